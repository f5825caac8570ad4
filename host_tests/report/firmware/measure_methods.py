#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What each rotation method costs on a core: the rows of methods.csv, and on Cortex-M0 those of flops.csv.

    measure_methods.py <methods.json>             prints the figures
    measure_methods.py <methods.json> --check     the same, and fails where the tables are stale
    measure_methods.py <methods.json> --update    writes them, in the rows of that build's core

methods.csv, of firmware that holds one body of the reference case `book` and turns it by the method, 1000 steps of 1/60 s:
  flash                         bytes beyond a firmware of nothing; kernel_flash: of these, what came from libingot_kernel.a
  world_ram                     sizeof(World)
  instructions_per_body_step    executed by the whole public step under QEMU, mean; instructions_worst: the worst step
flops.csv, of the same body at several rates, both scalars: operations on floating-point numbers of one whole public step, mean
of 128: adds (with subtractions), muls, divs, roots.
"""
import argparse
import csv
import json
import pathlib
import re
import subprocess
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "budgets"))
import measure  # noqa: E402

METHODS, FLOPS = HERE.parent.parent / "tables" / "methods.csv", HERE.parent.parent / "tables" / "flops.csv"
METHOD_FIGURES = ("flash", "kernel_flash", "world_ram", "instructions_per_body_step", "instructions_worst")
FLOP_FIGURES = ("adds", "muls", "divs", "roots")


def rows_of_methods(build):
    nothing_flash = measure.flash_of(build["objdump"], build["nothing"])
    nothing_printed = measure.run(build["emulator"], build["nothing"])
    rows = {}
    for method, elf in build["methods"].items():
        flash, printed = measure.flash_of(build["objdump"], elf), measure.run(build["emulator"], elf)
        rows[method, build["core"]] = (flash["all"] - nothing_flash["all"], flash["kernel"], printed["world_bytes"],
                                       printed["instructions_per_step"] - nothing_printed["instructions_per_step"],
                                       printed["worst_step"] - nothing_printed["worst_step"])
    return rows


def rows_of_flops(build):
    rows = {}
    for scalar, elf in build["flops"].items():
        printed = subprocess.run(build["emulator"] + [elf], check=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                 universal_newlines=True, timeout=600).stdout
        steps = int(re.search(r"steps (\d+)", printed)[1])
        for line in re.findall(r"(\w+) (\d+) adds (\d+) muls (\d+) divs (\d+) roots (\d+)", printed):
            rows[line[0], scalar, line[1]] = tuple("%.5g" % (int(count) / steps) for count in line[2:])
    return rows


def read(path, keys):
    if not path.exists():
        return {}
    with open(path, newline="", encoding="utf-8") as table:
        return {tuple(row[:keys]): tuple(row[keys:]) for row in list(csv.reader(table))[1:]}


def write(path, keys, figures, rows, before):
    """The new rows in their order, then those of the table that are not measured here."""
    kept = {key: row for key, row in before.items() if key not in rows}
    with open(path, "w", newline="", encoding="utf-8") as table:
        writer = csv.writer(table, lineterminator="\n")
        writer.writerow(keys + figures)
        for key, row in sorted({**kept, **rows}.items(), key=lambda item: (item[0][1], list(rows).index(item[0]) if item[0] in rows else -1)):
            writer.writerow(key + tuple(row))


def stale(name, rows, table):
    sentences = []
    for key, row in rows.items():
        if key not in table:
            sentences.append("%s: no row for %s" % (name, ", ".join(key)))
            continue
        for measured, written in zip(row, table[key]):
            measured, written = float(measured), float(written)
            if measured > written * (1 + measure.GROWTH_MAX) or measured < written * (1 - measure.SHRINKAGE_MAX):
                sentences.append("%s: %s: measured %g, the table says %g" % (name, ", ".join(key), measured, written))
    return sentences


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build", type=pathlib.Path, help="methods.json of a cross build")
    action = parser.add_mutually_exclusive_group()
    action.add_argument("--check", action="store_true")
    action.add_argument("--update", action="store_true")
    arguments = parser.parse_args()
    build = json.loads(arguments.build.read_text(encoding="utf-8"))
    build["emulator"] = build["emulator"].split(";")
    measure.take_tolerance(build)
    if build["compiler"] != measure.TABLE_COMPILER and (arguments.check or arguments.update):
        print("the tables are of gcc %s, this build of gcc %s: not compared" % (measure.TABLE_COMPILER, build["compiler"]))
        return 0

    methods, flops = rows_of_methods(build), rows_of_flops(build)
    for key, row in {**methods, **flops}.items():
        print(*key, *row)
    if arguments.update:
        old = {key: row for key, row in read(METHODS, 2).items() if key[1] != build["core"]}
        write(METHODS, ("method", "core"), METHOD_FIGURES, methods, old)
        if flops:
            write(FLOPS, ("method", "scalar", "rate"), FLOP_FIGURES, flops, {})
    if arguments.check:
        sentences = stale("methods.csv", methods, read(METHODS, 2)) + stale("flops.csv", flops, read(FLOPS, 3))
        for sentence in sentences:
            print("report:", sentence)
        if sentences:
            print("Make the rows anew: cmake --build <this build> --target report_methods_update")
        return 1 if sentences else 0
    return 0


if __name__ == "__main__":
    sys.exit(main())
