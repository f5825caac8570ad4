#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""house_test.py HOUSE [STEP FILE FUNCTION]: what keeps the house readable.

    The step is a page: step() in kernel/world/step.h has at most 25 lines and no `if constexpr`.
    A scene is asked in one place: no trait of a scene, `S::something`, is named outside of kernel/world.
    A file of kernel/ has at most 400 lines, and a function at most 60.
    toolchains/README.md names every file beside it.

There are no exceptions. STEP, FILE and FUNCTION are other limits, for a house of a few lines that breaks them.
"""
import pathlib
import re
import sys

STEP_MAX, FILE_MAX, FUNCTION_MAX = [int(limit) for limit in sys.argv[2:]] or [25, 400, 60]


def without_comments(text):
    """The source, with as many lines, without comments and strings."""
    blank = lambda match: "\n" * match.group(0).count("\n") if match.group(0).startswith("/") else '""'
    return re.sub(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"", blank, text, flags=re.S)


def closing(text, at):
    """The place of the brace that closes the one at `at`."""
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] == "{") - (text[i] == "}")
        if depth == 0:
            return i
    raise ValueError("braces that do not close")


def functions_of(text):
    """Name, first line and number of lines of each function that is defined; what it is declared with counts, lambdas in it do not count apart."""
    text = re.sub(r"^[ \t]*#(?:.*\\\n)*.*$", lambda match: "\n" * match.group(0).count("\n"), without_comments(text), flags=re.M)
    at = begin = 0
    while at < len(text):
        if text[at] in ";}" or text.startswith(("public:", "private:"), at):
            begin = at + (1 if text[at] in ";}" else 8)
        elif text[at] == "{":
            head = text[begin:at]
            end = closing(text, at)
            if re.search(r"\)\s*(?:const|noexcept|override|->[^;{]+|:[^;{]+|\s)*$", head) and not re.match(r"\s*(?:namespace|extern|enum)\b", head):
                first = begin + len(head) - len(head.lstrip())
                name = re.sub(r"\s+", " ", re.sub(r"^\s*template\s*<.*?>\s*(?=[\w\[])", "", head, flags=re.S)).strip()
                name = re.search(r"([\w~:]+|operator\s*\S+?)\s*\(", name)
                yield (name.group(1) if name else "?"), text.count("\n", 0, first) + 1, text.count("\n", first, end) + 1
                at = end
            elif re.search(r"=\s*(?:\w+\s*)?$|\[\]\s*$|,\s*$|\(\s*$", head):
                at = end + 1  # an initialiser
                continue
            begin = at + 1
        at += 1


def breaches_of(house):
    """A sentence for each place that breaks a rule."""
    paths = [path for path in sorted((house / "kernel").rglob("*")) if path.suffix in (".h", ".cpp")]
    assert paths, f"no kernel in {house}"
    for path in paths:
        name, text = path.relative_to(house).as_posix(), path.read_text()
        lines = text.count("\n")
        if lines > FILE_MAX:
            yield f"{name}: {lines} lines, the limit is {FILE_MAX}"
        for function, line, length in functions_of(text):
            limit = STEP_MAX if name == "kernel/world/step.h" and function == "step" else FUNCTION_MAX
            if length > limit:
                yield f"{name}:{line}: {function} has {length} lines, the limit is {limit}"
        code = without_comments(text).splitlines()
        for line, content in enumerate(code, 1):
            if name == "kernel/world/step.h" and re.search(r"\bif constexpr\b", content):
                yield f"{name}:{line}: a branch in the step: it belongs to an adaptor in stages.h"
            if not name.startswith("kernel/world/") and re.search(r"\bS::\w+", content):
                yield f"{name}:{line}: a trait of a scene is asked for outside of kernel/world"
    page = (house / "toolchains/README.md").read_text()
    for path in sorted((house / "toolchains").iterdir()):
        if path.is_file() and path.name != "README.md" and f"`{path.name}`" not in page:
            yield f"toolchains/README.md does not name {path.name}"


def main():
    breaches = list(breaches_of(pathlib.Path(sys.argv[1])))
    print("\n".join(breaches))
    sys.exit(1 if breaches else 0)


main()
