#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Branches of kernel/ that no host test takes.

    branches.py <build directory>... [--exclusions exclusions.csv] [--least 99]

Each build directory is one of INGOT_COVERAGE (clang), in which ctest has run. A branch is one outcome of one condition of the source: both
operands of && and || count, each with a true and a false side. Conditions that a template decides at compile time (if constexpr) are none, and
what is instantiated, built or inlined several times, for whatever scalar and lanes, is one: a side is taken when any test of any build takes it.
A template that nobody instantiates is not seen; compile.calls sees to it that every call of the interface is.

Prints a table of rooms and the sides that are not taken. Fails when less than 99 % of the sides that exclusions.csv does not list are taken, or
when it lists one that is taken: columns file, condition (as it stands in the source), side (true or false), reason.
"""
import argparse
import collections
import csv
import json
import os
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
KERNEL = os.path.join(ROOT, "kernel") + os.sep

Branch = collections.namedtuple("Branch", "file line column end_line end_column")


def tool(name):
    """llvm-cov and llvm-profdata go by their plain names or by those of the version that Debian's clang has."""
    for candidate in [name] + ["%s-%d" % (name, version) for version in range(22, 13, -1)]:
        if shutil.which(candidate):
            return candidate
    sys.exit("no " + name + ": install llvm")


def programs_of(build):
    """Executables of the build that carry a map of their branches."""
    for directory, _, names in os.walk(build):
        for name in names:
            path = os.path.join(directory, name)
            if os.access(path, os.X_OK) and not os.path.islink(path) and not name.endswith((".so", ".o", ".a")):
                with open(path, "rb") as file:
                    content = file.read()
                if content[:4] == b"\x7fELF" and b"__llvm_covmap" in content:
                    yield path


def branches_of(build):
    """{Branch: [times true, times false]} of all programs of a build."""
    profiles = [os.path.join(directory, name) for directory, _, names in os.walk(build) for name in names if name.endswith(".profraw")]
    if not profiles:
        sys.exit(build + " has no profiles: run ctest there")
    found = collections.defaultdict(lambda: [0, 0])
    with tempfile.NamedTemporaryFile(suffix=".profdata") as merged:
        subprocess.run([tool("llvm-profdata"), "merge", "-sparse", "-o", merged.name] + profiles, check=True)
        for program in sorted(programs_of(build)):
            export = subprocess.run([tool("llvm-cov"), "export", "-instr-profile=" + merged.name, program],
                                    check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
            for function in json.loads(export)["data"][0]["functions"]:
                files = function["filenames"]
                for line, column, end_line, end_column, true, false, file_i, _, _ in function["branches"]:
                    path = os.path.realpath(files[file_i])
                    if path.startswith(KERNEL):
                        sides = found[Branch(os.path.relpath(path, ROOT), line, column, end_line, end_column)]
                        sides[0] = max(sides[0], true)
                        sides[1] = max(sides[1], false)
    return found


def condition(branch, sources={}):
    """The text of a branch's condition, its white space folded."""
    if branch.file not in sources:
        with open(os.path.join(ROOT, branch.file)) as file:
            sources[branch.file] = file.read().split("\n")
    lines = sources[branch.file][branch.line - 1:branch.end_line]
    lines[-1] = lines[-1][:branch.end_column - 1]
    lines[0] = lines[0][branch.column - 1:]
    return " ".join(" ".join(lines).split())


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("builds", nargs="+")
    parser.add_argument("--exclusions", default=os.path.join(os.path.dirname(HERE), "tables", "exclusions.csv"))
    parser.add_argument("--least", type=float, default=99.0, help="per cent of the sides that are not excluded")
    arguments = parser.parse_args()

    taken = collections.defaultdict(lambda: [0, 0])
    for build in arguments.builds:
        for branch, sides in branches_of(build).items():
            for side in (0, 1):
                taken[branch][side] = max(taken[branch][side], sides[side])

    with open(arguments.exclusions) as file:
        excluded = {(row["file"], row["condition"], row["side"]): 0 for row in csv.DictReader(line for line in file if not line.startswith("#"))}

    rooms = collections.defaultdict(lambda: [0, 0, 0])  # sides, taken, excluded
    missing = []
    for branch, sides in sorted(taken.items()):
        room = rooms[branch.file.split("/")[1]]
        for name, times in (("true", sides[0]), ("false", sides[1])):
            key = (branch.file, condition(branch), name)
            room[0] += 1
            room[1] += times > 0
            if times == 0 and key in excluded:
                excluded[key] += 1
                room[2] += 1
            elif times == 0:
                missing.append("%s:%d: %s is never %s" % (branch.file, branch.line, condition(branch), name))

    print("%-10s %8s %8s %9s %8s" % ("room", "sides", "taken", "excluded", "per cent"))
    total = [sum(room[i] for room in rooms.values()) for i in range(3)]
    share = lambda room: 100.0 * room[1] / max(1, room[0] - room[2])
    for name, room in sorted(rooms.items()) + [("kernel", total)]:
        print("%-10s %8d %8d %9d %8.2f" % (name, *room, share(room)))
    for line in missing:
        print(line)
    stale = [key for key, count in excluded.items() if count == 0]
    for file, text, side in stale:
        print("excluded, and taken or gone: %s: %s, %s" % (file, text, side))
    if total[0] == 0 or share(total) < arguments.least or stale:
        sys.exit("branch coverage: %.2f %%, and %.2f %% are asked for; %d exclusions are stale" % (share(total), arguments.least, len(stale)))


if __name__ == "__main__":
    main()
