#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""flops.py TABLE PROGRAM: additions and multiplications, divisions and square roots of one step of each rotation method, one body, float, one lane.

Counted, not estimated: callgrind counts how often each machine instruction of the stages ran, objdump tells what it was. PROGRAM is
methods_main.cpp on the host, built with INGOT_LANES=1. Needs valgrind and binutils, on x86-64.
"""
import collections
import csv
import os
import re
import subprocess
import sys
import tempfile

from methods import STAGES

STEPS = 480  # of methods_main.cpp
# Stages that call functions of their own.
CALLS = {"exact_elliptic": r"|exact_turn|angle_about_L|polhode_of|JacobiOf|sin_cos\("}
KINDS = {"addss": "add_mul", "subss": "add_mul", "mulss": "add_mul", "divss": "div", "sqrtss": "sqrt"}


def mnemonics_of(program):
    text = subprocess.run(["objdump", "-d", "--no-show-raw-insn", program], check=True, stdout=subprocess.PIPE, universal_newlines=True).stdout
    return {int(m[1], 16): m[2].lstrip("v") for m in re.finditer(r"^\s+([0-9a-f]+):\s+(\S+)", text, re.M)}


def executed(program):
    """Calls and, by function, how often each address ran."""
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "callgrind.out")
        subprocess.run(["valgrind", "--tool=callgrind", "--dump-instr=yes", "--compress-pos=no", "--compress-strings=no",
                        "--callgrind-out-file=" + out, program], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        counts = collections.defaultdict(collections.Counter)
        function, skip = None, False
        with open(out) as file:
            for line in file:
                if line.startswith("fn="):
                    function = line[3:].strip()
                elif line.startswith("calls="):
                    skip = True
                elif line.startswith("0x"):
                    if not skip:
                        fields = line.split()
                        counts[function][int(fields[0], 16)] += int(fields[2])
                    skip = False
    return counts


def main(table, program):
    mnemonics, counts = mnemonics_of(program), executed(program)
    rows = []
    for method, pattern in STAGES.items():
        ops = collections.Counter()
        for function, by_address in counts.items():
            if not re.search(pattern + CALLS.get(method, ""), re.sub(r"f32x1::", "", function)):
                continue
            for address, count in by_address.items():
                kind = KINDS.get(mnemonics.get(address, ""))
                if kind:
                    ops[kind] += count
        rows.append([method] + ["%.1f" % (ops[kind] / STEPS) for kind in ("add_mul", "div", "sqrt")])
    with open(table, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["method", "add_mul", "div", "sqrt"])
        writer.writerows(rows)


if __name__ == "__main__":
    main(*sys.argv[1:])
