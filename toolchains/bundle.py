#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the kernel as few files, for projects that copy sources instead of building ingot with CMake.

    bundle.py --out <folder> [--scalar float|double] [--lanes 1|2|4|8|16] [--index-bits 16|32] [--flat | --arduino]

    ingot.h, ingot.cpp        the whole kernel; scalar, lanes and the width of indices are fixed in ingot.h
    ingot_level.h             tables of levels by the compiler and from bytes; level/mesh_of.h and the others include it
    --flat                    ingot.h, ingot_stages.h, and one ingot_<room>_<stage>.cpp per stage: what a program does not call is
                              not linked, even where the linker drops whole objects only
    --arduino                 a library for the Arduino IDE: the flat form in src/ingot, library.properties, examples. Nobody can give its units a
                              flag, so they keep the floating-point contract by themselves, and so does every unit from ingot.h on: see KEEPS

Compile every unit that includes ingot.h, your own too, with

    -std=c++17 -fno-fast-math -ffp-contract=off -fno-math-errno        (32-bit x86: and -msse2 -mfpmath=sse)

and, for vectors of more than 16 bytes, with -Wno-psabi (no vector crosses a call, so it does not matter how one would), on x86 also with -mavx2:
the templates of the step are compiled in your unit.

Packages for other tools are written by platform/packages/package.py, which uses what is here. A run with the same arguments writes the same bytes.
"""
import argparse
import os
import re
import shutil

KERNEL = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "kernel")
INCLUDE_OWN = re.compile(r'\s*#\s*include\s+"([^"]+)"')
INCLUDE_SYSTEM = re.compile(r"\s*#\s*include\s+<([^>]+)>")
# What users include beside ingot.h.
LEVEL_HEADERS = ("level/byte_heights_of.h", "level/height_field_of.h", "level/level_from_bytes.h", "level/level_materials.h", "level/level_walk.h", "level/mesh_of.h")
LICENSE_LINE = "// SPDX-License-Identifier: MIT"
HOUSE = os.path.normpath(os.path.join(KERNEL, ".."))

# Ahead of every unit that no flag reaches. GCC's #pragma STDC FP_CONTRACT is without effect. There is no pop_options behind ingot.h: templates are
# instantiated at the end of the unit, what is always inlined takes the options of who calls it, and what a program computes for ingot is of its bits too.
KEEPS = """\
// The floating-point contract of this unit, from here to its end: a * b + c is rounded twice.
#if defined(__clang__)
#pragma clang fp contract(off)
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-math-errno")
#endif
"""
# Friends that are defined within a class template have the options of the command line all the same (GCC 12), unless they say theirs.
INLINE_OF_SIZE = "#define INGOT_INLINE inline"
KEEPING_INLINE = """\
#if defined(__GNUC__) && !defined(__clang__)
#define INGOT_INLINE __attribute__((optimize("fp-contract=off", "no-math-errno"))) inline
#else
#define INGOT_INLINE inline
#endif"""
OLD_COMPILER = """\
#if __cplusplus < 201703L && !(defined(_MSVC_LANG) && _MSVC_LANG >= 201703L)
#error "ingot: this is C++17, and the unit is compiled as something older; take a core (board package) that compiles with -std=gnu++17"
#endif
"""


def read_lines(path):
    with open(os.path.join(KERNEL, path), encoding="utf-8") as source:
        return source.read().splitlines()


def project():
    """What project() of the root says: the one place where the version is written, but for base/version.h, which a test compares with it."""
    with open(os.path.join(HOUSE, "CMakeLists.txt"), encoding="utf-8") as root:
        said = re.search(r"^project\((\w+)(.*?)\)$", root.read(), re.M | re.S)
    found = dict(re.findall(r'(VERSION|DESCRIPTION|HOMEPAGE_URL) "?([^"\n]*?)"?(?= [A-Z_]+ |$)', said[2], re.M))
    return {"PROJECT_NAME": said[1], "PROJECT_VERSION": found["VERSION"], "PROJECT_DESCRIPTION": found["DESCRIPTION"],
            "PROJECT_HOMEPAGE_URL": found.get("HOMEPAGE_URL", "")}


def filled(template, values):
    """@NAME@ by its value; a line whose value is empty, as that of an address nobody has given, is left out."""
    lines = []
    for line in template.split("\n"):
        names = re.findall(r"@([A-Z_]+)@", line)
        if all(values[name] for name in names):
            lines.append(re.sub(r"@([A-Z_]+)@", lambda name: values[name[1]], line))
    return "\n".join(lines)


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
    """What a unit declares in its unnamed namespace, by the first columns of its lines. Returns: types and functions, constants."""
    names, constants, inside = set(), set(), False
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
                constants |= set(re.findall(r"(\w+)(?:\[[^\]]*\])* =", line))
    return names, constants


def without_clashes(units):
    """Units that go into one file share one unnamed namespace: a name that two of them declare, and a constant that a variable of another one would
    hide, gets the name of its stage."""
    declared = [local_names(lines) for _, lines in units]
    words = [set(re.findall(r"\w+", "\n".join(line.split("//")[0] for line in lines))) for _, lines in units]
    renamed = []
    for (path, lines), (own, constants) in zip(units, declared):
        stage = os.path.splitext(os.path.basename(path))[0]
        clashing = {name for name in own if sum(name in names for names, _ in declared) > 1}
        hidden = {name for name in constants if sum(name in used for used in words) > 1}
        for name in sorted(clashing | hidden):
            lines = [re.sub(r"(?<!\.)(?<!->)(?<!::)\b%s\b" % name, name + "_of_" + stage, line) for line in lines]
        renamed.append((path, lines))
    return renamed


def head_of(scalar, lanes, index_bits, keeps):
    """A scalar of None: as the build says, by INGOT_DOUBLE, INGOT_LANES and INGOT_INDEX_BITS, in all units."""
    options = "-std=c++17 -fno-fast-math -ffp-contract=off -fno-math-errno"
    wide = scalar is None or lanes * (8 if scalar == "double" else 4) > 16
    if wide:
        options += " -Wno-psabi"
    kind = "of the scalar and the lanes that the build says" if scalar is None else "for %s in %d lane%s" % (scalar, lanes, "" if lanes == 1 else "s")
    head = ["// ingot %s %s. Generated by toolchains/bundle.py from the sources of the kernel: change those." % (project()["PROJECT_VERSION"], kind), "//"]
    if keeps:
        head += ["// This file keeps what the bits of results depend on in every unit that includes it, from there to its end. Include it first."]
    else:
        head += ["// Compile every unit that includes this file with " + options + ",",
                 "// on 32-bit x86 also with -msse2 -mfpmath=sse. The bits of results depend on it."]
    if wide and scalar is not None:
        head += ["//", "// On x86 compile every unit that includes this file with -mavx2 too: its vectors are of more than 16 bytes."]
    head += ["#pragma once", ""]
    if keeps:
        head += [KEEPS + OLD_COMPILER]
    fixed = (("INGOT_LANES", lanes), ("INGOT_DOUBLE", 1 if scalar == "double" else 0), ("INGOT_INDEX_BITS", index_bits))
    for macro, value in fixed if scalar is not None else ():
        head += ["#if defined(%s) && %s != %d" % (macro, macro, value),
                 '#error "ingot: this bundle was generated for %s=%d"' % (macro, value),
                 "#endif", "#undef " + macro, "#define %s %d" % (macro, value)]
    return head + [""]


def write_bundle(out, scalar="float", lanes=1, index_bits=16, flat=False, keeps=False):
    """Returns: the names of the units, in order."""
    os.makedirs(os.path.join(out, "level"), exist_ok=True)

    def write(name, text):
        with open(os.path.join(out, name), "w", encoding="utf-8", newline="\n") as file:
            file.write(text)

    header = Pasted()
    header.paste("ingot.h")
    text = header.text(head_of(scalar, lanes, index_bits, keeps))
    if keeps:
        assert text.count("\n" + INLINE_OF_SIZE + "\n") == 1, "kernel/base/config.h: where helpers are not inlined"
        text = text.replace("\n" + INLINE_OF_SIZE + "\n", "\n" + KEEPING_INLINE + "\n")
    write("ingot.h", text)

    level = Pasted(header)
    for path in LEVEL_HEADERS:
        if path not in level.headers:
            level.paste(path)
    write("ingot_level.h", level.text(["// Tables of levels; see ingot.h.", "#pragma once", "", '#include "ingot.h"']))
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
    if not flat:
        for _, lines in without_clashes(units):
            stages.lines += lines
        write("ingot.cpp", stages.text(["// The kernel of ingot; see ingot.h.", '#include "ingot.h"', ""]))
        return ["ingot.cpp"]
    write("ingot_stages.h", stages.text(["// What the stages of ingot share. Users include ingot.h.", "#pragma once", "", '#include "ingot.h"']))
    names = []
    for path, lines in units:
        names.append("ingot_" + path.replace("/", "_"))
        write(names[-1], "\n".join([LICENSE_LINE] + ([KEEPS] if keeps else []) + ['#include "ingot_stages.h"'] + lines) + "\n")
    return names


def write_arduino(out):
    """A folder to be copied among the libraries of the Arduino IDE."""
    own = os.path.join(HOUSE, "platform", "packages", "arduino")
    os.makedirs(out, exist_ok=True)
    write_bundle(os.path.join(out, "src", "ingot"), flat=True, keeps=True)
    shutil.copyfile(os.path.join(own, "ingot.h"), os.path.join(out, "src", "ingot.h"))
    shutil.copyfile(os.path.join(HOUSE, "LICENSE"), os.path.join(out, "LICENSE"))
    shutil.copytree(os.path.join(own, "examples"), os.path.join(out, "examples"), dirs_exist_ok=True)
    with open(os.path.join(own, "library.properties.in"), encoding="utf-8") as template:
        text = filled(template.read(), project())
    with open(os.path.join(out, "library.properties"), "w", encoding="utf-8", newline="\n") as file:
        file.write(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", required=True)
    parser.add_argument("--scalar", choices=("float", "double"), default="float")
    parser.add_argument("--lanes", type=int, choices=(1, 2, 4, 8, 16), default=1)
    parser.add_argument("--index-bits", type=int, choices=(16, 32), default=16)
    parser.add_argument("--flat", action="store_true")
    parser.add_argument("--arduino", action="store_true")
    arguments = parser.parse_args()
    if arguments.arduino:
        write_arduino(arguments.out)
    else:
        write_bundle(arguments.out, arguments.scalar, arguments.lanes, arguments.index_bits, arguments.flat)


if __name__ == "__main__":
    main()
