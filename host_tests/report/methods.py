#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""methods.py TABLE CORE NM FIRMWARE EMULATOR...: runs the firmware and puts its rows into the table, with the code size of each stage."""
import csv
import re
import subprocess
import sys

COLUMNS = ["method", "core", "instructions_per_body_step", "instructions_worst", "code"]
STAGES = {"default": r"integrate_A_moser_veselov<6, true, true>", "listing1_euler": r"integrate_A_listing1\(", "lie_midpoint": r"LieMidpoint::integrate_A",
          "rk4_polar": r"Rk4Polar::integrate_A", "moser_veselov_2": r"integrate_A_moser_veselov<2, true, true>",
          "moser_veselov_4": r"integrate_A_moser_veselov<4, true, true>", "moser_veselov_4_plain": r"integrate_A_moser_veselov<4, false, false>",
          "moser_veselov_6_plain": r"integrate_A_moser_veselov<6, false, false>", "moser_veselov_8": r"integrate_A_moser_veselov<8, true, true>",
          "moser_veselov_10": r"integrate_A_moser_veselov<10, true, true>", "symmetric_top_splitting_2": r"SymmetricTopSplitting<2>::integrate_A",
          "symmetric_top_splitting_6": r"SymmetricTopSplitting<6>::integrate_A", "exact_elliptic": r"ExactElliptic::integrate_A",
          "symmetric_top": r"SymmetricTop::integrate_A"}


def main(table, core, nm, firmware, *emulator):
    printed = subprocess.run([*emulator, firmware], check=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True).stdout
    symbols = subprocess.run([nm, "-C", "-S", firmware], check=True, stdout=subprocess.PIPE, universal_newlines=True).stdout
    measured = []
    for line in printed.splitlines():
        found = re.fullmatch(r"(\w+) (\d+) (\d+)", line.strip())
        if not found:
            continue
        sizes = [int(s.split()[1], 16) for s in symbols.splitlines() if re.search(STAGES[found[1]], s) and re.match(r"[0-9a-f]+ [0-9a-f]+ [tTwW] ", s)]
        measured.append([found[1], core, found[2], found[3], str(max(sizes))])
    if len(measured) != len(STAGES):
        sys.exit("methods: the firmware printed\n" + printed)
    with open(table, newline="") as file:
        rows = [row for row in list(csv.reader(file))[1:] if row[1] != core]
    with open(table, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        writer.writerows(rows + measured)


if __name__ == "__main__":
    main(*sys.argv[1:])
