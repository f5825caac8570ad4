#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the kernel as few files, for projects that copy sources instead of building ingot with CMake.

    bundle.py --out <folder> [--scalar float|double] [--lanes 1|2|4|8|16] [--index-bits 16|32] [--flat]

    ingot.h, ingot.cpp        the whole kernel; scalar, lanes and the width of indices are fixed in ingot.h
    ingot_level.h             tables of levels by the compiler and from bytes; level/mesh_of.h and the others include it
    --flat                    ingot.h, ingot_stages.h, and one ingot_<room>_<stage>.cpp per stage: what a program does not call is
                              not linked, even where the linker drops whole objects only

Compile every unit that includes ingot.h, your own too, with

    -std=c++17 -fno-fast-math -ffp-contract=off -fno-math-errno        (32-bit x86: and -msse2 -mfpmath=sse)

and, for vectors of more than 16 bytes, with -Wno-psabi (no vector crosses a call, so it does not matter how one would), on x86 also with -mavx2:
the templates of the step are compiled in your unit.

A run with the same arguments writes the same bytes.
"""
import argparse
import os
import re

KERNEL = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "kernel")
INCLUDE_OWN = re.compile(r'\s*#\s*include\s+"([^"]+)"')
INCLUDE_SYSTEM = re.compile(r"\s*#\s*include\s+<([^>]+)>")
# What users include beside ingot.h.
LEVEL_HEADERS = ("level/height_field_of.h", "level/level_from_bytes.h", "level/level_walk.h", "level/mesh_of.h")
LICENSE_LINE = "// SPDX-License-Identifier: MIT"


def read_lines(path):
    with open(os.path.join(KERNEL, path), encoding="utf-8") as source:
        return source.read().splitlines()


def sources():
    """The .cpp files of the kernel, by name, so that the order is the same everywhere."""
    found = []
    for folder, _, names in os.walk(KERNEL):
        found += [os.path.relpath(os.path.join(folder, name), KERNEL) for name in names if name.endswith(".cpp")]
    return sorted(path.replace(os.sep, "/") for path in found)


class Pasted:
    """Text with its own includes pasted in, each header once, before the first line that needs it."""

    def __init__(self, before=None):
        self.headers = set(before.headers) if before else set()  # already there, or to be found in `before`
        self.system = set()
        self.lines = []

    def paste(self, path):
        self.headers.add(path)
        body = []
        conditions = 0  # around the line: what is included under one stays there
        for line in read_lines(path):
            directive = re.match(r"\s*#\s*(if|endif)", line)
            if directive:
                conditions += 1 if directive[1] == "if" else -1
            own = INCLUDE_OWN.match(line)
            system = INCLUDE_SYSTEM.match(line) if conditions == 0 else None
            if own:
                header = os.path.normpath(os.path.join(os.path.dirname(path), own[1])).replace(os.sep, "/")
                if header not in self.headers:
                    self.paste(header)
            elif system:
                self.system.add(system[1])
            elif line not in (LICENSE_LINE, "#pragma once"):
                body.append(line)
        while body and not body[0]:
            body.pop(0)
        self.lines += ["", "// ---- " + path + " ----"] + body

    def text(self, head):
        lines = [LICENSE_LINE] + head + ["#include <%s>" % name for name in sorted(self.system)] + self.lines
        return re.sub(r"\n{3,}", "\n\n", "\n".join(lines)) + "\n"


def local_names(lines):
    """What a unit declares in its unnamed namespace, by the first columns of its lines."""
    names, inside = set(), False
    for line in lines:
        if line == "namespace {":
            inside = True
        elif line == "}  // namespace":
            inside = False
        elif inside:
            type_name = re.match(r"(?:struct|class|enum class|enum|union|using(?! namespace)) (\w+)", line)
            function = re.match(r"[A-Za-z_][\w:<>,&* ]*[ &*](\w+)\(", line)
            if type_name:
                names.add(type_name[1])
            elif function:
                names.add(function[1])
            elif re.match(r"(?:inline |static )*(?:const|constexpr) ", line):
                names |= set(re.findall(r"(\w+)(?:\[[^\]]*\])? =", line))
    return names


def without_clashes(units):
    """Units that go into one file share one unnamed namespace: a name that two of them declare gets the name of its stage."""
    declared = [local_names(lines) for _, lines in units]
    renamed = []
    for (path, lines), own in zip(units, declared):
        stage = os.path.splitext(os.path.basename(path))[0]
        for name in sorted(own):
            if sum(name in names for names in declared) > 1:
                lines = [re.sub(r"(?<!\.)(?<!->)(?<!::)\b%s\b" % name, name + "_of_" + stage, line) for line in lines]
        renamed.append((path, lines))
    return renamed


def head_of(scalar, lanes, index_bits):
    number = {line.split()[1]: line.split()[2] for line in read_lines("base/version.h") if re.match(r"#define INGOT_VERSION_\w+ \d", line)}
    version = ".".join(number["INGOT_VERSION_" + part] for part in ("MAJOR", "MINOR", "PATCH"))
    options = "-std=c++17 -fno-fast-math -ffp-contract=off -fno-math-errno"
    wide = lanes * (8 if scalar == "double" else 4) > 16
    if wide:
        options += " -Wno-psabi"
    fixed = (("INGOT_LANES", lanes), ("INGOT_DOUBLE", 1 if scalar == "double" else 0), ("INGOT_INDEX_BITS", index_bits))
    head = [
        "// ingot %s for %s in %d lane%s. Generated by toolchains/bundle.py from the sources of the kernel: change those." %
        (version, scalar, lanes, "" if lanes == 1 else "s"),
        "//",
        "// Compile every unit that includes this file with " + options + ",",
        "// on 32-bit x86 also with -msse2 -mfpmath=sse. The bits of results depend on it.",
    ]
    if wide:
        head += ["//", "// On x86 compile every unit that includes this file with -mavx2 too: its vectors are of more than 16 bytes."]
    head += ["#pragma once", ""]
    for macro, value in fixed:
        head += ["#if defined(%s) && %s != %d" % (macro, macro, value),
                 '#error "ingot: this bundle was generated for %s=%d"' % (macro, value),
                 "#endif", "#undef " + macro, "#define %s %d" % (macro, value)]
    return head + [""]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", required=True)
    parser.add_argument("--scalar", choices=("float", "double"), default="float")
    parser.add_argument("--lanes", type=int, choices=(1, 2, 4, 8, 16), default=1)
    parser.add_argument("--index-bits", type=int, choices=(16, 32), default=16)
    parser.add_argument("--flat", action="store_true")
    arguments = parser.parse_args()
    os.makedirs(arguments.out, exist_ok=True)

    def write(name, text):
        with open(os.path.join(arguments.out, name), "w", encoding="utf-8", newline="\n") as out:
            out.write(text)

    header = Pasted()
    header.paste("ingot.h")
    write("ingot.h", header.text(head_of(arguments.scalar, arguments.lanes, arguments.index_bits)))

    level = Pasted(header)
    for path in LEVEL_HEADERS:
        if path not in level.headers:
            level.paste(path)
    write("ingot_level.h", level.text(["// Tables of levels; see ingot.h.", "#pragma once", "", '#include "ingot.h"']))
    os.makedirs(os.path.join(arguments.out, "level"), exist_ok=True)
    for path in LEVEL_HEADERS:
        write(path, "\n".join([LICENSE_LINE, "#pragma once", '#include "../ingot_level.h"']) + "\n")

    # What stages share and users do not see, pasted ahead of the stages that need it.
    stages = Pasted(header)
    units = []
    for path in sources():
        unit = Pasted(stages)
        unit.paste(path)
        marks = [i for i, line in enumerate(unit.lines) if line.startswith("// ---- ")]
        stages.lines += unit.lines[:marks[-1] - 1]
        stages.headers |= unit.headers - {path}
        stages.system |= unit.system
        units.append((path, unit.lines[marks[-1] - 1:]))
    if arguments.flat:
        write("ingot_stages.h", stages.text(["// What the stages of ingot share. Users include ingot.h.", "#pragma once", "", '#include "ingot.h"']))
        for path, lines in units:
            name = "ingot_" + path.replace("/", "_")
            write(name, "\n".join([LICENSE_LINE, '#include "ingot_stages.h"'] + lines) + "\n")
    else:
        for _, lines in without_clashes(units):
            stages.lines += lines
        write("ingot.cpp", stages.text(["// The kernel of ingot; see ingot.h.", '#include "ingot.h"', ""]))


if __name__ == "__main__":
    main()
