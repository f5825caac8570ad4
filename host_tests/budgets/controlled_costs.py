#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a step of a figure with its controller costs on a core: the rows of controlled_costs.csv.

    controlled_costs.py <controlled.json>             prints the figures of a cross build
    controlled_costs.py <controlled.json> --check     the same, and fails where the table is stale
    controlled_costs.py <controlled.json> --update    writes them, in the rows of that build's core

world_ram       bytes, sizeof(World)
step_mean, step_worst, steering_mean
                instructions of a step, and of the controller before it, of 300 steps of 1/60 s, under QEMU
share           of what a core of 400 MHz has in 1/60 s, percent, if each instruction took a cycle: of step_mean and steering_mean
flops_mean, flops_worst
                operations on floating-point numbers, adds, muls, divs and roots, of controller and step, and of the worst step; counted on a
                Cortex-M3, where each is a call, and 0 elsewhere
"""
import argparse
import csv
import json
import pathlib
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import measure  # noqa: E402

TABLE = HERE.parent / "tables" / "controlled_costs.csv"
FIGURES = ("world_ram", "step_mean", "step_worst", "steering_mean", "share", "flops_mean", "flops_worst")
CYCLES = 400_000_000 / 60


def rows_of(build):
    rows = {}
    for scene, elf in build["controlled"].items():
        printed = measure.run(build["emulator"], elf, 1)
        counted = measure.run(build["emulator"], build["counted"][scene], 1) if scene in build["counted"] else {"mean": 0, "worst": 0}
        share = 100 * (printed["instructions_per_step"] + printed["steering_per_step"]) / CYCLES
        rows[scene, build["core"]] = tuple(str(figure) for figure in (
            printed["world_bytes"], printed["instructions_per_step"], printed["worst_step"], printed["steering_per_step"], "%.1f" % share,
            counted["mean"], counted["worst"]))
    return rows


def complaints(rows, table):
    for key, row in rows.items():
        if key not in table:
            yield "no row for %s on %s" % key
            continue
        for figure, measured, written in zip(FIGURES, row, table[key]):
            if figure == "share":
                continue
            if not float(written) * (1 - measure.SHRINKAGE_MAX) <= float(measured) <= float(written) * (1 + measure.GROWTH_MAX):
                yield "%s of %s on %s: measured %s, the table says %s" % (figure, *key, measured, written)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build", type=pathlib.Path, help="controlled.json of a cross build")
    action = parser.add_mutually_exclusive_group()
    action.add_argument("--check", action="store_true")
    action.add_argument("--update", action="store_true")
    arguments = parser.parse_args()
    build = json.loads(arguments.build.read_text(encoding="utf-8"))
    build["emulator"] = build["emulator"].split(";")
    measure.take_tolerance(build)
    if build["compiler"] != measure.TABLE_COMPILER and (arguments.check or arguments.update):
        print("the table is of gcc %s, this build of gcc %s: not compared" % (measure.TABLE_COMPILER, build["compiler"]))
        return measure.EXIT_SKIPPED
    rows = rows_of(build)
    for key, row in rows.items():
        print(*key, *("%s %s" % pair for pair in zip(FIGURES, row)))
    table = {}
    if TABLE.exists():
        with open(TABLE, newline="", encoding="utf-8") as file:
            table = {(row["scene"], row["core"]): tuple(row[figure] for figure in FIGURES) for row in csv.DictReader(file)}
    if arguments.update:
        table = {key: row for key, row in table.items() if key[1] != build["core"]}
        table.update(rows)
        with open(TABLE, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(("scene", "core") + FIGURES)
            for key in sorted(table, key=lambda key: (key[1], key[0])):
                writer.writerow(key + table[key])
    if arguments.check:
        found = list(complaints(rows, table))
        for sentence in found:
            print("controlled:", sentence)
        return 1 if found else 0
    return 0


if __name__ == "__main__":
    sys.exit(main())
