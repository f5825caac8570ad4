#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The slowest step in the fuzzers' corpora on a Cortex-M4F, and how far it is from the median: worst_steps.csv.

    worst_steps.py <worst_steps.json>              prints the figures
    worst_steps.py <worst_steps.json> --check      the same, and fails where a worst step left its budget
    worst_steps.py <worst_steps.json> --update     writes them into worst_steps.csv
    worst_steps.py <worst_steps.json> --keep       copies the inputs of the worst steps to fuzz/slow, of a build that played others

../README.md says what each column means. The programs print every step (play_corpus.cpp), so medians are exact. CMake writes
worst_steps.json. Tolerances are those of the budgets.
"""
import argparse
import csv
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import measure  # noqa: E402

TABLE = HERE.parent.parent / "tables" / "worst_steps.csv"
FUZZ = HERE.parents[2] / "fuzz"
ALL = "all"  # the scenes of a machine taken together
KEY_COLUMNS = ("machine", "scene")
COLUMNS = KEY_COLUMNS + ("inputs", "steps", "median", "p99", "worst", "ratio", "contact_steps", "contact_median", "contact_ratio",
                         "worst_contacts", "worst_step", "worst_input")
RUN_SECONDS_MAX = 3600  # of a machine; the longest takes 15
SEARCH_SECONDS_MAX = 3600  # of thousands of inputs


def printed_by(emulator, elf, runs, seconds_max):
    """What a program prints, in so many runs the same."""
    printed = []
    for _ in range(runs):
        try:
            done = subprocess.run(emulator + [elf], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True, timeout=seconds_max)
        except subprocess.TimeoutExpired:
            raise measure.Failure("%s has not ended after %d s" % (elf, seconds_max))
        if done.returncode != 0:
            raise measure.Failure("%s ended with %d:\n%s" % (elf, done.returncode, done.stdout[-2000:]))
        printed.append(done.stdout)
    if any(text != printed[0] for text in printed):
        raise measure.Failure("%s printed two things in two runs" % elf)
    return printed[0]


def steps_of(printed):
    """All steps that a machine printed, as [(input, number of the step in it from 1, scene, instructions, contacts)]."""
    steps, number = [], 0
    for line in printed.splitlines():
        word, rest = line.split(" ", 1)
        if word == "input":
            name, number = rest, 0
        elif word == "scene":
            scene = name_of_scene(rest)
        else:
            number += 1
            steps.append((name, number, scene, int(word), int(rest)))
    return steps


def name_of_scene(signature):
    """SymmetricTop of "... counted_step(...) [with S = {anonymous}::SymmetricTop; scalar = float]"."""
    scene = re.search(r"\[with S = (.*?)(;.*)?\]$", signature)[1]
    return re.sub(r"\{anonymous\}::|ingot::(\w+::)?", "", scene).replace(" >", ">")


def rank(sorted_values, share):
    """The smallest value that this share of all does not exceed; 0 of none."""
    return sorted_values[max(math.ceil(share * len(sorted_values)) - 1, 0)] if sorted_values else 0


def ratio(values):
    """Largest to median, with three figures; 0 of none."""
    return "%g" % float("%.3g" % (values[-1] / rank(values, 0.5))) if values else "0"


def row_of(machine, scene, steps):
    """The row of these steps."""
    instructions = sorted(step[3] for step in steps)
    of_contacts = sorted(step[3] for step in steps if step[4] > 0)
    worst = max(steps, key=lambda step: step[3])  # the first of equals
    return {
        "machine": machine, "scene": scene, "inputs": len({step[0] for step in steps}), "steps": len(steps),
        "median": rank(instructions, 0.5), "p99": rank(instructions, 0.99), "worst": worst[3], "ratio": ratio(instructions),
        "contact_steps": len(of_contacts), "contact_median": rank(of_contacts, 0.5), "contact_ratio": ratio(of_contacts),
        "worst_contacts": worst[4], "worst_step": worst[1], "worst_input": worst[0],
    }


def rows_of(machine, steps):
    """A row for each scene that took a step, and one for all of them. Scenes that are one another but for the rotation share that one."""
    if not steps:
        raise measure.Failure("%s took no step" % machine)
    scenes = sorted({step[2] for step in steps if "<" not in step[2]})
    return [row_of(machine, scene, [step for step in steps if step[2] == scene]) for scene in scenes] + [row_of(machine, ALL, steps)]


def read_table(path):
    """Rows by (machine, scene), `worst` as a number."""
    with open(path, newline="", encoding="utf-8") as table:
        return {(row["machine"], row["scene"]): {**row, "worst": int(row["worst"])} for row in csv.DictReader(table)}


def compare(rows, table, machines):
    """All complaints, as sentences: of the worst steps, and of scenes that came or went."""
    complaints = []
    for row in rows:
        budget = table.get((row["machine"], row["scene"]))
        if budget is None:
            complaints.append("%s, %s has no row in the table" % (row["machine"], row["scene"]))
            continue
        reason = measure.complaint("worst", row["worst"], budget["worst"])
        if reason:
            complaints.append("%s, %s: worst %s" % (row["machine"], row["scene"], reason))
    gone = {key for key in table if key[0] in machines} - {(row["machine"], row["scene"]) for row in rows}
    return complaints + ["%s, %s is in the table, and took no step" % key for key in sorted(gone)]


def keep(rows, slow_inputs):
    """Copies inputs of worst steps that are not in the corpus."""
    for row in rows:
        found = pathlib.Path(slow_inputs) / row["machine"] / row["worst_input"]
        to = FUZZ / "slow" / row["machine"]
        if found.exists() and not any(FUZZ.glob("corpus*/" + found.name)):
            to.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(found, to / found.name)


def print_rows(rows):
    cells = [COLUMNS] + [tuple(str(row[column]) for column in COLUMNS) for row in rows]
    widths = [max(len(line[i]) for line in cells) for i in range(len(COLUMNS))]
    for line in cells:
        print("  ".join(cell.ljust(width) if i < 2 else cell.rjust(width) for i, (cell, width) in enumerate(zip(line, widths))))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build", type=pathlib.Path, help="worst_steps.json of a build for Cortex-M4F")
    action = parser.add_mutually_exclusive_group()
    action.add_argument("--check", action="store_true", help="fail where a worst step left its budget")
    action.add_argument("--update", action="store_true", help="write the figures into the table")
    action.add_argument("--keep", action="store_true", help="copy the inputs of the worst steps to fuzz/slow")
    parser.add_argument("--table", type=pathlib.Path, default=TABLE)
    parser.add_argument("--machines", help="only these, by comma")
    arguments = parser.parse_args()

    build = json.loads(arguments.build.read_text(encoding="utf-8"))
    measure.take_tolerance(build)
    emulator = build["emulator"].split(";")
    if build["compiler"] != measure.TABLE_COMPILER and (arguments.check or arguments.update):
        print("worst_steps.csv is of gcc %s, this build of gcc %s: not compared" % (measure.TABLE_COMPILER, build["compiler"]))
        return measure.EXIT_SKIPPED
    machines = arguments.machines.split(",") if arguments.machines else list(build["machines"])
    try:
        # A check is a second run by itself: the table is of the first. In a search it does not matter.
        runs = 2 if arguments.update else 1
        seconds_max = SEARCH_SECONDS_MAX if arguments.keep else RUN_SECONDS_MAX
        printed = {machine: printed_by(emulator, build["machines"][machine], runs, seconds_max) for machine in machines}
        rows = [row for machine in machines for row in rows_of(machine, steps_of(printed[machine]))]
    except measure.Failure as why:
        print("worst_steps: %s" % why)
        return 1
    print_rows(rows)

    if arguments.update:
        with open(arguments.table, "w", newline="", encoding="utf-8") as table:
            writer = csv.DictWriter(table, COLUMNS, lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)
        print("written to %s" % arguments.table)
    if arguments.keep:
        keep(rows, build["slow_inputs"])
    complaints = compare(rows, read_table(arguments.table), machines) if arguments.check else []
    for sentence in complaints:
        print("worst_steps: %s" % sentence)
    if complaints:
        print("\nWhat to do: a new input of a corpus may be slower than all before it. If it is none, see what changed in the kernel. Then\n"
              "    cmake --build --preset cortex-m4f --target worst_steps_update\n"
              "and say in the commit why the step takes longer.")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
