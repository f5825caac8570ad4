#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every loop of kernel/ and what bounds it.

    loops.py [<folder>]            checks: fails when a loop has no bound, or a comment bounds no loop
    loops.py [<folder>] --list     prints all loops with their bounds

A loop is counted when its header says `from; i < limit; ++i` (or <=, !=, a step, or downwards to a constant) and nothing in it changes i. Limits that
are numbers, constants, or made of them, and arrays (`for (x : array)`) are their own bounds. Any other limit is bounded by a comment in the line
of the loop, or above it, which holds for all counted loops of the file with this limit:

    for (int i = 0; i < solver.body_count; ++i) {  // bound: max_bodies

Any other loop has a comment of its own, and the comment says why it ends:

    // bound: max_manifolds: begin becomes end, which is after it
    while (begin < solver.manifold_count) {
"""
import collections
import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

Loop = collections.namedtuple("Loop", "file line header limit last_line")
CONSTANT = re.compile(r"\bconstexpr\s+(?:[\w:]+\s+)*?(\w+)\s*=")
VARIABLE = re.compile(r"(?<!constexpr )(?:\b(?:int|unsigned|auto|u?int\d+_t|size_t)\b[\s&*]+)(\w+)")
BOUND = re.compile(r"//.*?\bbound: (.+)")


def without_comments(text):
    """The source, with as many lines, without comments and strings."""
    blank = lambda match: "\n" * match.group(0).count("\n") if match.group(0).startswith("/") else '""'
    return re.sub(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"", blank, text, flags=re.S)


def closing(text, at, pair):
    """The place after the bracket that closes the one at `at`."""
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] == pair[0]) - (text[i] == pair[1])
        if depth == 0:
            return i + 1
    raise ValueError("brackets that do not close")


def body_of(text, at):
    """The statement that begins at `at`."""
    while text[at].isspace():
        at += 1
    if text[at] == "{":
        return text[at:closing(text, at, "{}")]
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] in "({[") - (text[i] in ")}]")
        if depth == 0 and text[i] in ";}" or depth < 0:
            return text[at:i + 1]
    raise ValueError("a statement that does not end")


def changes(body, name):
    """True where a statement may change the variable."""
    n = re.escape(name)
    return bool(re.search(r"(\+\+|--|(?<![&\w])&)\s*%s\b|\b%s\s*(\+\+|--|[-+*/|&^%%]=|>>=|<<=|=(?!=))" % (n, n), body))


def limit_of(header, body):
    """What the counter of a counted loop stays below or reaches; "" for an array; None for other loops."""
    parts = header.split(";")
    if len(parts) == 1:
        return "" if re.search(r"[^:]:[^:]", header) else None
    if len(parts) != 3:
        return None
    begin = re.match(r"\s*(?:const\s+)?[\w:]+\s+(\w+)\s*=\s*(.+?)\s*$", parts[0], re.S)
    if not begin:
        return None
    name, start = begin.groups()
    step = parts[2].strip()
    up = re.match(r"(\+\+%s|%s \+= \w+)\b" % (name, name), step)
    down = re.match(r"(--%s|%s -= \w+)\b" % (name, name), step)
    if not (up or down) or changes(body, name) or ("," in step and changes(step.split(",", 1)[1], name)):
        return None
    for condition in re.split(r"\s*&&\s*", parts[1].strip()):
        bound = re.match(r"%s\s*(<=|<|!=|>=|>)\s*(.+)$" % name, condition, re.S)
        if bound and up and bound.group(1) in ("<", "<=", "!="):
            return " ".join(bound.group(2).split())
        if bound and down and bound.group(1) in (">", ">="):
            return " ".join(re.sub(r",.*", "", start, flags=re.S).split())
    return None


def loops_of(path):
    with open(path) as file:
        text = without_comments(file.read())
    name = os.path.relpath(path, ROOT)
    for match in re.finditer(r"\b(for|while)\s*\(|\bdo\s*\{", text):
        line = text.count("\n", 0, match.start()) + 1
        if match.group(0).startswith("do"):
            yield Loop(name, line, "do", None, line)
            continue
        at = match.end() - 1
        end = closing(text, at, "()")
        last_line = text.count("\n", 0, end) + 1
        header = " ".join(text[at + 1:end - 1].split())
        if match.group(1) == "while":
            if text[end:].lstrip().startswith(";") and text[:match.start()].rstrip().endswith("}"):
                continue  # of do
            yield Loop(name, line, "while " + header, None, last_line)
        else:
            body = body_of(text, end)
            yield Loop(name, line, "for " + header, limit_of(header, body), last_line)


def constants_of(paths):
    """Names that are constants wherever they are declared."""
    constants, variables = set(), set()
    for path in paths:
        with open(path) as file:
            text = without_comments(file.read())
        constants |= set(CONSTANT.findall(text))
        variables |= set(VARIABLE.findall(text))
    return constants - variables


def bounds_of(path):
    """Bounds by the number of their line; those in a comment of its own are of the line below it."""
    with open(path) as file:
        lines = file.read().split("\n")
    bounds = {}
    for number, line in enumerate(lines):
        found = BOUND.search(line)
        if found:
            while lines[number].strip().startswith("//"):
                number += 1
            bounds[number + 1] = found[1].strip()
    return bounds


def is_constant(limit, constants):
    limit = re.sub(r"\bsizeof(\([^()]*\)| \w+)", "0", limit)
    words = re.findall(r"[A-Za-z_][\w:]*", limit)
    return all(word == "lanes" or word.startswith("limits::") or word.split("::")[-1] in constants for word in words) and not re.search(r"[.\[>?]", limit)


def bounded(path, constants):
    """The loops of a file as [(loop, bound or None)], and the lines of comments that bound none."""
    loops, bounds, used = list(loops_of(path)), bounds_of(path), set()
    own, of_limit = {}, {}
    for loop in loops:
        for line in range(loop.line, loop.last_line + 1):
            if line in bounds and line not in used:
                used.add(line)
                own[loop] = bounds[line]
                of_limit.setdefault(loop.limit, bounds[line])
                break
    told = []
    for loop in loops:
        bound = own.get(loop)
        if bound is None and loop.limit is not None:
            bound = (loop.limit or "the array") if is_constant(loop.limit, constants) else of_limit.get(loop.limit)
        told.append((loop, bound))
    return told, ["%s:%d: bounds no loop" % (os.path.relpath(path, ROOT), line) for line in sorted(set(bounds) - used)]


def main():
    folder = next((argument for argument in sys.argv[1:] if not argument.startswith("--")), os.path.join(ROOT, "kernel"))
    paths = sorted(os.path.join(directory, name) for directory, _, names in os.walk(folder) for name in names if name.endswith((".h", ".cpp")))
    constants = constants_of(paths)
    loops, faults = [], []
    for path in paths:
        told, stray = bounded(path, constants)
        loops += told
        faults += ["%s:%d: %s: no bound: say `// bound: <what>`%s" % (loop.file, loop.line, loop.header, ", and why it ends" if loop.limit is None else
                                                                  " of " + loop.limit) for loop, bound in told if bound is None] + stray
    if "--list" in sys.argv:
        for loop, bound in loops:
            print("%s:%d: %s: %s" % (loop.file, loop.line, loop.header, bound))
    counted = sum(loop.limit is not None for loop, _ in loops)
    print("%d loops: %d counted, %d with a reason of their own" % (len(loops), counted, len(loops) - counted))
    if faults or not loops:
        sys.exit("\n".join(faults))


if __name__ == "__main__":
    main()
