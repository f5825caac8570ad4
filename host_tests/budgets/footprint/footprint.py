#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What each shape, solver and feature takes on a Cortex-M4F: the rows of footprint.csv and the tables of FOOTPRINT.md.

    footprint.py <footprint.json> --update    measures, writes both and prints the tables
    footprint.py <footprint.json> --check     measures, and fails where footprint.csv is stale
    footprint.py --check                      fails where FOOTPRINT.md is not what the tables of figures make it
    footprint.py --update                     writes it from them, and measures nothing

A row is a firmware of footprint_scenes.h; flash and world_ram are those of ../README.md. Tolerances are those of the budgets.
"""
import argparse
import csv
import json
import pathlib
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import calls  # noqa: E402
import measure  # noqa: E402

TABLES = HERE.parent.parent / "tables"
WORST_STEPS = TABLES / "worst_steps.csv"
TABLE, PAGE = TABLES / "footprint.csv", TABLES / "FOOTPRINT.md"
FIGURES = ("flash", "world_ram")
BUDGET_SCENES = {"satellite": "a satellite that turns", "ten_boxes_row": "ten boxes side by side", "ten_boxes_column": "ten boxes in a column",
                 "ten_boxes_on_budget": "the same, each contact visited up to 20 times",
                 "playground": "eight bodies with many features", "double_pendulum": "a pendulum of two rods on hinges",
                 "arm_6": "an arm of six hinges"}
CORES = {"cortex-m0": "M0", "cortex-m4f": "M4F", "cortex-m7": "M7"}

HEAD = """<!-- SPDX-License-Identifier: MIT -->
# What it takes

Written by `cmake --build --preset cortex-m4f --target footprint`; release builds of arm-none-eabi-gcc %s. Flash is what a firmware has beyond
start-up and console, with set-up and all checks of arguments; RAM is `sizeof(World)`, and the stack comes on top.

## Shapes, solvers, features

On a Cortex-M4F, in bytes. What a scene does not name costs nothing.

"""
CORES_HEAD = """
## Three cores

Figures of `budgets.csv`, in bytes and in instructions of one step of 1/60 s: the last of the scene, and the worst. A Cortex-M0 computes floats in
software.

"""
MACHINES = {"world": "impacts without friction, and free bodies", "numbers": "two bodies in states at the edges of what is taken",
            "snapshot": "forged snapshots, a step each", "friction": "contacts with friction",
            "rooms": "hulls, bodies of several shapes, direct solves, sleep, fast bodies", "materials": "rolling resistance, surfaces that move",
            "light": "`SequentialImpulses`", "drift": "free bodies, and nothing else"}
WORST_HEAD = """
## Slowest steps

Figures of `worst_steps.csv`: instructions of a step on a Cortex-M4F, of all steps of the fuzzers' corpora and of `fuzz/slow`. These are
random calls with numbers at every edge, of up to seven bodies, in steps of up to 1 s, and inputs that a fuzzer found by looking for slow steps. The median
is over all steps, most of them of a world where little touches, and over those with contacts.

"""
CALLS_HEAD = """
## Stack of calls

Figures of `calls.csv`, in bytes, of the deepest way through each public function: those that take more than %d on one of the cores. Each is called
in a scene that names most of what it looks at, all six shapes among them (`public_calls.cpp`); with fewer it takes less, as the steps above do.
`step_...` is `step()` of one scene after another.

"""
CALLS_STACK_MIN = 500  # bytes; calls with no more than this on any core share a row


def measured(build, rows):
    nothing = measure.flash_of(build["objdump"], build["nothing"])["all"]
    for row in rows:
        elf = build["scenes"][row["scene"]]
        row["flash"] = measure.flash_of(build["objdump"], elf)["all"] - nothing
        row["world_ram"] = measure.run(build["emulator"], elf, 1)["world_bytes"]
    return rows


def table(cells):
    """Markdown; the first column is text."""
    lines = ["| " + " | ".join(line) + " |" for line in cells]
    return "\n".join([lines[0], "| --- |" + " ---: |" * (len(cells[0]) - 1)] + lines[1:]) + "\n"


def table_of_features(rows):
    by_scene = {row["scene"]: row for row in rows}
    cells = [("scene, and what it names beside", "flash", "RAM")]
    for row in rows:
        base = by_scene.get(row["base"])
        if base is None:
            cells.append((row["what"],) + tuple("%d" % row[figure] for figure in FIGURES))
        else:
            cells.append(("  and " + row["what"],) + tuple("%+d" % (row[figure] - base[figure]) for figure in FIGURES))
    return table([tuple(cell.strip() for cell in line) for line in cells])


def table_of_cores(budgets):
    cells = [("scene", "core", "flash", "RAM", "stack", "last step", "worst step")]
    for scene, title in BUDGET_SCENES.items():
        for core, short in CORES.items():
            row = budgets.get((scene, core))
            if row:
                cells.append((title, short) + tuple("%d" % row[figure] for figure in (
                    "flash", "world_ram", "stack_computed", "instructions_last", "instructions_worst")))
    return table(cells)


def table_of_worst_steps(source):
    cells = [("what is played", "steps", "median", "99 %", "worst", "worst / median", "median with contacts", "worst / this median")]
    for row in csv.DictReader(source):
        if row["scene"] == "all":
            cells.append((MACHINES[row["machine"]],) + tuple(row[column] if row[column] != "0" else "" for column in (
                "steps", "median", "p99", "worst", "ratio", "contact_median", "contact_ratio")))
    return table(cells)


def table_of_calls(stacks):
    """Deepest first; calls that take the same share a row."""
    names = list(dict.fromkeys(name for name, _ in stacks))
    cores = [core for core in CORES if any(of == core for _, of in stacks)]
    names_of = {}
    for name in names:
        names_of.setdefault(tuple(stacks.get((name, core), 0) for core in cores), []).append(name)
    rows = sorted(names_of.items(), reverse=True, key=lambda row: row[0])
    large = [row for row in rows if max(row[0]) > CALLS_STACK_MIN]
    small = [row for row in rows if max(row[0]) <= CALLS_STACK_MIN]
    cells = [("call",) + tuple(CORES[core] for core in cores)]
    cells += [(", ".join("`%s`" % name for name in same),) + tuple("%d" % stack for stack in figures) for figures, same in large]
    if small:
        count = sum(len(same) for _, same in small)
        cells.append(("%d others, at most" % count,) + tuple("%d" % max(of_core) for of_core in zip(*(figures for figures, _ in small))))
    return table(cells)


def page(rows):
    with open(WORST_STEPS, newline="", encoding="utf-8") as source:
        worst_steps = table_of_worst_steps(source)
    return (HEAD % measure.TABLE_COMPILER + table_of_features(rows) + CORES_HEAD + table_of_cores(measure.read_table(measure.TABLE))
            + WORST_HEAD + worst_steps + CALLS_HEAD % CALLS_STACK_MIN + table_of_calls(calls.read_table(calls.TABLE)))


def read_rows():
    with open(TABLE, newline="", encoding="utf-8") as source:
        return [{**row, **{figure: int(row[figure]) for figure in FIGURES}} for row in csv.DictReader(source)]


def write_rows(rows):
    with open(TABLE, "w", newline="", encoding="utf-8") as target:
        writer = csv.DictWriter(target, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build", type=pathlib.Path, nargs="?", help="footprint.json of a build for Cortex-M4F")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--update", action="store_true")
    arguments = parser.parse_args()
    if arguments.build is None:
        if arguments.update:
            PAGE.write_text(page(read_rows()), encoding="utf-8")
            return 0
        if not arguments.check:
            parser.error("nothing to do")
        if PAGE.read_text(encoding="utf-8") == page(read_rows()):
            return 0
        print("FOOTPRINT.md is not what the tables make it: cmake --build --preset cortex-m4f --target footprint")
        return 1

    build = json.loads(arguments.build.read_text(encoding="utf-8"))
    build["emulator"] = build["emulator"].split(";")
    measure.take_tolerance(build)
    if build["compiler"] != measure.TABLE_COMPILER:
        print("footprint.csv is of gcc %s, this build of gcc %s: not compared" % (measure.TABLE_COMPILER, build["compiler"]))
        return 1 if arguments.update else 0
    rows = measured(build, read_rows())
    if arguments.update:
        write_rows(rows)
        PAGE.write_text(page(rows), encoding="utf-8")
        print(page(rows))
    complaints = []
    if arguments.check:
        for row, kept in zip(rows, read_rows()):
            reasons = [(figure, measure.complaint(figure, row[figure], kept[figure])) for figure in FIGURES]
            complaints += ["%s: %s %s" % (row["scene"], figure, reason) for figure, reason in reasons if reason]
    for sentence in complaints:
        print("footprint: " + sentence)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
