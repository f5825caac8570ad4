#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Worst-case stack of every public function on a core, computed and compared with calls.csv.

    calls.py <calls.json>              prints the figures
    calls.py <calls.json> --check      the same, and fails where they left the budget
    calls.py <calls.json> --update     writes them into calls.csv, in the rows of that build's core
    calls.py --listed                  fails on a public function that public_calls.cpp does not call

The stack is that of call_graph.py, tolerances are those of measure.py. CMake writes calls.json.
"""
import argparse
import collections
import csv
import json
import pathlib
import re
import sys

sys.dont_write_bytecode = True  # the source tree stays as it is
import call_graph  # noqa: E402
import measure  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
TABLE, SOURCE = HERE.parent / "tables" / "calls.csv", HERE / "public_calls.cpp"
KERNEL = HERE.parents[1] / "kernel"
COLUMNS = ("call", "core", "stack")
PREFIX = "call_"

# Headers that ingot.h names for something else than their functions: step and snapshots are known as friends of World, and
# fields are called by the step; what drawing takes is that of the user's pen.
FUNCTIONS_ARE_NOT_PUBLIC = ("motion/force_fields.h", "world/draw.h", "world/snapshot.h", "world/step.h", "world/world.h")


def members_of_world(text):
    """Names of the public member functions of World, or of a part of it, as often as they are declared. One a line, four columns in: clang-format sees to it."""
    public = re.search(r"^class World\w*(?: : [^\n]*)? \{\n(.*?)^(?:private:|\};|protected:(?!.*^public:))\n", text, re.M | re.S)[1].split("\npublic:\n", 1)[1]
    return collections.Counter(re.findall(r"^ {4}(?!static_assert)[A-Za-z][^(\n]*?(\w+)\(", public, re.M))


def friends_of_world(text):
    return collections.Counter(re.findall(r"^ {4}friend [^(\n]*?(\w+)\(", text, re.M))


def free_functions(text):
    """Names of the functions of a header, as often as they are declared; without those of inner namespaces."""
    text = re.sub(r"^namespace (\w+) \{$.*?^\}  // namespace \1$", "", text, flags=re.M | re.S)
    text = re.sub(r"__attribute__\(\(\w+\)\) ", "", text)
    return collections.Counter(re.findall(r"^(?!static_assert|template|using|namespace)[A-Za-z][^(=\n]*?(\w+)\(", text, re.M))


def missing_calls(kernel, source):
    """Public functions that the source calls less often than they have overloads, as sentences."""
    parts = [kernel / "world" / name for name in ("world.h", "world_adds.h", "world_bodies.h", "world_touching.h", "world_edits.h", "world_kinematic.h", "world_joints.h", "world_dynamics.h", "world_contacts.h", "world_queries.h", "world_mover.h")]
    parts = [part.read_text(encoding="utf-8") for part in parts if part.exists()]  # the test of this has one of them
    members = sum((members_of_world(part) for part in parts), collections.Counter())
    free = r"\b(?<!\.)"
    wanted = [(r"world\.", "World::", members), (free, "", friends_of_world(parts[0]))]
    for header in re.findall(r'^#include "(.*)"$', (kernel / "ingot.h").read_text(encoding="utf-8"), re.M):
        if header not in FUNCTIONS_ARE_NOT_PUBLIC:
            wanted.append((free, "", free_functions((kernel / header).read_text(encoding="utf-8"))))
    text = source.read_text(encoding="utf-8")
    sentences = []
    for before, shown, names in wanted:
        for name, overloads in names.items():
            calls = len(re.findall(before + name + r"(?:<[\w, ]*>)?\(", text))
            if calls < overloads:
                sentences.append("%s%s has %d declarations in public, and %d calls in %s" % (shown, name, overloads, calls, source.name))
    return sentences


def computed(build, source):
    """Rows of all calls of a build, in the order of the source."""
    functions = call_graph.read_firmware(build["objdump"], build["program"], build["objects"].split(";"))
    address_of = {function.name: address for address, function in functions.items()}
    rows, known = [], {}
    for call in re.findall(r"^CALL\((\w+)\)", source.read_text(encoding="utf-8"), re.M):
        try:
            stack, _ = call_graph.deepest(functions, address_of[PREFIX + call], known=known)
        except call_graph.Unbounded as why:
            raise measure.Failure("%s: stack without bound: %s" % (call, why))
        rows.append({"call": call, "core": build["core"], "stack": stack})
    return rows


def read_table(path):
    """Stack in bytes by (call, core)."""
    with open(path, newline="", encoding="utf-8") as table:
        return {(row["call"], row["core"]): int(row["stack"]) for row in csv.DictReader(table)}


def write_table(path, table):
    with open(path, "w", newline="", encoding="utf-8") as target:
        writer = csv.writer(target, lineterminator="\n")
        writer.writerow(COLUMNS)
        writer.writerows([call, core, stack] for (call, core), stack in table.items())


def compare(rows, table):
    """All complaints about computed rows of one core, as sentences."""
    complaints = []
    for row in rows:
        where, budget = "%s on %s" % (row["call"], row["core"]), table.get((row["call"], row["core"]))
        if budget is None:
            complaints.append("%s has no row in the table" % where)
            continue
        reason = measure.complaint("stack", row["stack"], budget)
        if reason:
            complaints.append("%s: stack %s" % (where, reason))
    there, cores = {(row["call"], row["core"]) for row in rows}, {row["core"] for row in rows}
    return complaints + ["%s on %s is in the table, and no call" % key for key in table if key[1] in cores and key not in there]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build", type=pathlib.Path, nargs="?", help="calls.json of a cross build")
    action = parser.add_mutually_exclusive_group()
    action.add_argument("--check", action="store_true", help="fail where a stack left its budget")
    action.add_argument("--update", action="store_true", help="write the figures into the table")
    action.add_argument("--listed", action="store_true", help="fail on a public function without a call")
    parser.add_argument("--keep", type=pathlib.Path, help="write the figures there too")
    parser.add_argument("--kept", type=pathlib.Path, help="take the figures from there: that they are of this build is for who says so")
    parser.add_argument("--table", type=pathlib.Path, default=TABLE)
    parser.add_argument("--source", type=pathlib.Path, default=SOURCE)
    arguments = parser.parse_args()
    if arguments.listed:
        complaints = missing_calls(KERNEL, arguments.source)
        for sentence in complaints:
            print("calls: %s" % sentence)
        return 1 if complaints else 0
    if arguments.build is None:
        parser.error("which build?")

    build = json.loads(arguments.build.read_text(encoding="utf-8"))
    measure.take_tolerance(build)
    if build["compiler"] != measure.TABLE_COMPILER and (arguments.check or arguments.update):
        print("calls.csv is of gcc %s, this build of gcc %s: not compared" % (measure.TABLE_COMPILER, build["compiler"]))
        return measure.EXIT_SKIPPED
    table = read_table(arguments.table) if arguments.table.exists() else {}
    try:
        rows = json.loads(arguments.kept.read_text(encoding="utf-8")) if arguments.kept else computed(build, arguments.source)
    except measure.Failure as why:
        print("calls: %s" % why)
        return 1
    if arguments.keep:
        arguments.keep.write_text(json.dumps(rows), encoding="utf-8")
    for row in rows:
        budget = table.get((row["call"], row["core"]))
        print("%6d  %s%s" % (row["stack"], row["call"], "" if budget == row["stack"] else "   (table: %s)" % ("no row" if budget is None else budget)))

    if arguments.update:
        table = {key: stack for key, stack in table.items() if key[1] != build["core"]}
        table.update({(row["call"], row["core"]): row["stack"] for row in rows})
        write_table(arguments.table, dict(sorted(table.items(), key=lambda item: item[0][1])))
        print("written to %s" % arguments.table)
    if not arguments.check:
        return 0
    complaints = compare(rows, table)
    for sentence in complaints:
        print("calls: %s" % sentence)
    if complaints:
        print("\nIf it is worth it, make the rows anew by the target budgets_update, and say in the commit what the bytes buy.")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
