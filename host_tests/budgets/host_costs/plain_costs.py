#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the plain C++ way costs beside the one with the compiler's words (kernel/base/compiler.h): instructions of a step on the host, under callgrind.

    plain_costs.py --update NAME=PROGRAM...     writes ../../tables/plain_costs.csv
    plain_costs.py --check NAME=PROGRAM...      fails where a figure has moved by more than 5 % from it

Names are "4 lanes", "1 lane", "plain, 1 lane", "plain, 4 lanes": plain_main.cpp with such kernels. Fails too where they do not end with the same bits.
"""
import csv
import pathlib
import re
import subprocess
import sys
import tempfile

TABLE = pathlib.Path(__file__).resolve().parents[2] / "tables/plain_costs.csv"
SCENES = {"flying": "64 bodies that fly", "piled": "a heap of 32 boxes and 32 balls", "hanging": "16 chains of four links"}
STEPS = 20


def instructions(program, scene):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out"
        subprocess.run(["valgrind", "-q", "--tool=callgrind", "--instr-atstart=no", "--collect-atstart=no", "--combine-dumps=yes",
                        f"--callgrind-out-file={out}", program, scene], check=True, stdout=subprocess.DEVNULL)
        return sum(int(total) for total in re.findall(r"^totals: (\d+)", out.read_text(), re.M)) / STEPS


def main():
    programs = dict(argument.split("=", 1) for argument in sys.argv[2:])
    hashes = {subprocess.run([program], check=True, capture_output=True, text=True).stdout for program in programs.values()}
    if len(hashes) != 1:
        sys.exit("plain_costs: they do not end with the same bits:\n" + "\n".join(sorted(hashes)))
    rows = []
    for scene, title in SCENES.items():
        counted = {name: instructions(program, scene) for name, program in programs.items()}
        rows.append({"scene": title, **{name: f"{count:.0f}" for name, count in counted.items()},
                     **{f"plain, 1 lane / {name}": f"{counted['plain, 1 lane'] / counted[name]:.2f}" for name in ("1 lane", "4 lanes") if name in counted}})
        print(*rows[-1].values(), sep="  ", flush=True)
    if sys.argv[1] == "--update":
        with open(TABLE, "w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, rows[0], lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)
        return
    with open(TABLE, newline="", encoding="utf-8") as file:
        kept = list(csv.DictReader(file))
    complaints = [f"{row['scene']}, {column}: {row[column]}, and {old[column]} in the table" for row, old in zip(rows, kept) for column in old
                  if column != "scene" and abs(float(row[column]) / float(old[column]) - 1) > 0.05]
    if complaints or len(rows) != len(kept):
        sys.exit("plain_costs: cmake --build ... --target update_plain_costs\n" + "\n".join(complaints))


main()
