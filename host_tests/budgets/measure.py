#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What each scene costs on a core: flash, RAM, stack and instructions, measured and compared with budgets.csv.

    measure.py <build directory>              prints the figures
    measure.py <build directory> --check      the same, and fails where they left the budget
    measure.py <build directory> --update     writes them into budgets.csv, in the rows of that build's core

README.md says what each column means. CMake writes budgets.json into the build directory: it knows the core, the tools and
the programs, so nothing is guessed here.
"""
import argparse
import concurrent.futures
import csv
import json
import os
import pathlib
import re
import subprocess
import sys

sys.dont_write_bytecode = True  # the source tree stays as it is
import call_graph  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
TABLE = HERE.parent / "tables" / "budgets.csv"

# Figures belong to a compiler, and to the libgcc that comes with it: with another they tell about that compiler, not about
# ingot, and are not compared. A new one here means all rows made anew.
TABLE_COMPILER = "12.2.1"

KEY_COLUMNS = ("scene", "core")
FIGURES = ("flash", "kernel_flash", "helpers_flash", "world_ram", "stack_computed", "stack_measured", "instructions_mean",
           "instructions_worst", "instructions_last")
COLUMNS = KEY_COLUMNS + FIGURES

# All figures repeat to the last digit, so the tolerances are not for noise but for people. 5 % of growth lets a bug be mended
# without a change of the table; the nightly run, where small steps have added up, lets 2 % pass (INGOT_BUDGET_GROWTH). It counts from the
# table, not from the last commit. Whoever saves more than 10 % writes it down: a table that is far above the truth would let the savings
# be lost again.
GROWTH_MAX = 0.05
SHRINKAGE_MAX = 0.10
# sizeof is decided in headers and means snapshots of another layout: any change is a change of the table.
EXACT = ("world_ram",)

EXIT_SKIPPED = 77  # what ctest takes for "not run", see SKIP_RETURN_CODE
RUN_SECONDS_MAX = 1200  # of a firmware in the emulator; the longest takes 2


def take_tolerance(build):
    """What a build allows its figures to grow by."""
    global GROWTH_MAX
    GROWTH_MAX = build["growth_percent"] / 100


class Failure(Exception):
    """A figure that cannot be taken, or that contradicts another."""


def flash_of(objdump, elf):
    """Bytes in flash by who brought them: {"all": ..., "kernel": ..., "helpers": ...}.

    All is what the sections hold that are loaded; the shares are the pieces that the linker's map gives to the archives.
    What lies between two pieces to align them is in "all" only.
    """
    headers = subprocess.run([objdump, "-h", elf], check=True, stdout=subprocess.PIPE, universal_newlines=True).stdout
    sections = re.findall(r"^ *\d+ (\S+) +([0-9a-f]+) .*\n +(CONTENTS, ALLOC, LOAD.*)$", headers, re.M)
    flash = {"all": sum(int(size, 16) for _, size, _ in sections), "kernel": 0, "helpers": 0}
    loaded = {name for name, _, _ in sections}

    text = pathlib.Path(elf + ".map").read_text(encoding="utf-8").split("Linker script and memory map", 1)[1]
    text = re.sub(r"^( \.\S+)\n\s+", r"\1 ", text, flags=re.M)  # long names have a line of their own
    section = ""
    for line in text.splitlines():
        if re.match(r"\.", line):
            section = line.split()[0]
        piece = re.match(r" \.\S+\s+0x[0-9a-f]+\s+0x([0-9a-f]+)\s+(\S+)", line)
        if section not in loaded or not piece:
            continue
        if "libingot_kernel.a(" in piece[2]:
            flash["kernel"] += int(piece[1], 16)
        elif re.search(r"/lib(gcc|c|c_nano|m)\.a\(", piece[2]):
            flash["helpers"] += int(piece[1], 16)
    return flash


def run(emulator, elf, times):
    """What a firmware prints, as {"label": number}. What differs between two runs is not a figure."""
    printed = []
    for _ in range(times):
        done = subprocess.run(emulator + [elf], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              universal_newlines=True, timeout=RUN_SECONDS_MAX)
        if done.returncode != 0:
            raise Failure("%s ended with %d:\n%s" % (elf, done.returncode, done.stdout))
        printed.append(done.stdout)
    if printed[0] != printed[-1]:
        raise Failure("%s printed two things in two runs:\n%s%s" % (elf, *printed))
    return {label: int(number) for label, number in re.findall(r"(\w+) (\d+)\b", printed[0])}


def measure(build, scene, nothing_flash, nothing_printed, times):
    """The row of a scene."""
    programs = build["scenes"][scene]
    flash = flash_of(build["objdump"], programs["firmware"])
    printed = run(build["emulator"], programs["firmware"], times)
    try:
        objects = build["kernel_objects"].split(";") + programs["objects"].split(";")
        stack_computed, _ = call_graph.worst_stack(build["objdump"], programs["probe"], objects, build["root"])
    except call_graph.Unbounded as why:
        raise Failure("%s: stack without bound: %s" % (scene, why))
    stack_measured = run(build["emulator"], programs["probe"], times)["stack_bytes"]
    if stack_measured > stack_computed:
        raise Failure("%s: the stack went %d bytes deep, computed were %d: the call graph misses something"
                      % (scene, stack_measured, stack_computed))
    return {
        "scene": scene,
        "core": build["core"],
        "flash": flash["all"] - nothing_flash["all"],
        "kernel_flash": flash["kernel"],
        "helpers_flash": flash["helpers"] - nothing_flash["helpers"],
        "world_ram": printed["world_bytes"],
        "stack_computed": stack_computed,
        "stack_measured": stack_measured,
        "instructions_mean": printed["instructions_per_step"] - nothing_printed["instructions_per_step"],
        "instructions_worst": printed["worst_step"] - nothing_printed["worst_step"],
        "instructions_last": printed["last_step"] - nothing_printed["last_step"],
    }


def read_table(path):
    """Rows of the table by (scene, core), figures as numbers."""
    with open(path, newline="", encoding="utf-8") as table:
        rows = list(csv.DictReader(table))
    return {(row["scene"], row["core"]): {**row, **{figure: int(row[figure]) for figure in FIGURES}} for row in rows}


def write_table(path, rows):
    with open(path, "w", newline="", encoding="utf-8") as table:
        writer = csv.DictWriter(table, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def complaint(figure, measured, budget):
    """Why a figure is not what the table says, or None."""
    if figure in EXACT:
        return None if measured == budget else "is %d, the table says %d (exact)" % (measured, budget)
    if measured > budget * (1 + GROWTH_MAX):
        return "grew from %d to %d: more than %g %%" % (budget, measured, 100 * GROWTH_MAX)
    if measured < budget * (1 - SHRINKAGE_MAX):
        return "shrank from %d to %d: more than %g %%, the table is stale" % (budget, measured, 100 * SHRINKAGE_MAX)
    return None


def compare(rows, table):
    """All complaints about measured rows, as sentences."""
    complaints = []
    for row in rows:
        where = "%s on %s" % (row["scene"], row["core"])
        budget = table.get((row["scene"], row["core"]))
        if budget is None:
            complaints.append("%s has no row in the table" % where)
            continue
        for figure in FIGURES:
            reason = complaint(figure, row[figure], budget[figure])
            if reason:
                complaints.append("%s: %s %s" % (where, figure, reason))
    return complaints


def print_rows(rows, table):
    """One line a scene; below each figure how far it is from the table's, where it is."""
    widths = [max(len(column), 10) for column in COLUMNS]
    line = lambda cells: "  ".join(str(cell).rjust(width) for cell, width in zip(cells, widths))
    print(line(COLUMNS))
    for row in rows:
        print(line([row[column] for column in COLUMNS]))
        budget = table.get((row["scene"], row["core"]))
        if budget and any(budget[figure] != row[figure] for figure in FIGURES):
            print(line(["", "since the table"] + ["%+d" % (row[f] - budget[f]) if budget[f] != row[f] else "" for f in FIGURES]))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build", type=pathlib.Path, help="build directory of a cross build")
    action = parser.add_mutually_exclusive_group()
    action.add_argument("--check", action="store_true", help="fail where a figure left its budget")
    action.add_argument("--update", action="store_true", help="write the figures into the table")
    parser.add_argument("--table", type=pathlib.Path, default=TABLE)
    parser.add_argument("--scenes", help="only these, by comma")
    arguments = parser.parse_args()

    build = json.loads((arguments.build / "host_tests/budgets/budgets.json").read_text(encoding="utf-8"))
    build["emulator"] = build["emulator"].split(";")
    take_tolerance(build)
    if build["compiler"] != TABLE_COMPILER and (arguments.check or arguments.update):
        print("budgets.csv is of gcc %s, this build of gcc %s: not compared" % (TABLE_COMPILER, build["compiler"]))
        return EXIT_SKIPPED

    table = read_table(arguments.table) if arguments.table.exists() else {}
    scenes = arguments.scenes.split(",") if arguments.scenes else list(build["scenes"])
    try:
        nothing_flash = flash_of(build["objdump"], build["nothing"])
        times = 1 if arguments.check else 2  # what --check compares with was taken twice
        nothing_printed = run(build["emulator"], build["nothing"], times)
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:  # the emulator counts instructions, no time
            rows = list(pool.map(lambda scene: measure(build, scene, nothing_flash, nothing_printed, times), scenes))
    except Failure as why:
        print("budgets: %s" % why)
        return 1
    print_rows(rows, table)

    if arguments.update:
        gone = {key for key in table if key[1] == build["core"] and key[0] not in build["scenes"]}
        table = {key: row for key, row in table.items() if key not in gone}
        table.update({(row["scene"], row["core"]): row for row in rows})
        write_table(arguments.table, sorted(table.values(), key=lambda row: row["core"]))
        print("written to %s" % arguments.table)
    if not arguments.check:
        return 0
    complaints = compare(rows, table)
    for sentence in complaints:
        print("budgets: %s" % sentence)
    if complaints:
        print("\nWhat to do: find what changed (README.md, \"Where the bytes are\"). If it is worth it, make the rows anew,\n"
              "    cmake --build %s --target budgets_update\n"
              "and say in the commit what the bytes buy." % arguments.build)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
