#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a step costs on the host, in instructions: who sleeps costs nothing, and who is far away costs what it costs alone.

    host_costs.py PROGRAM            runs each world under valgrind and prints the median and the worst of its steps
    host_costs.py PROGRAM --check    and fails where a row of host_costs.csv that holds is beyond its limit, or one that does not is within

A row's limit is of the median step of its world, in instructions; or, where it names worlds to compare with, of its ratio to the sum of theirs.
`holds` is `no` where the kernel is not there yet.
"""
import csv
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

TABLE = pathlib.Path(__file__).resolve().parents[2] / "tables/host_costs.csv"


def steps_of(program, world):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out"
        subprocess.run(["valgrind", "-q", "--tool=callgrind", "--instr-atstart=no", "--collect-atstart=no", "--combine-dumps=yes",
                        f"--callgrind-out-file={out}", program, world], check=True)
        counts = [int(total) for total in re.findall(r"^totals: (\d+)", out.read_text(), re.M)]
    return [count for count in counts if count > 0]


def main():
    program, check = sys.argv[1], "--check" in sys.argv[2:]
    with open(TABLE, newline="") as file:
        rows = list(csv.DictReader(file))
    median, complaints = {}, []
    print(f"{'world':28}{'median':>12}{'worst':>12}")
    for world in dict.fromkeys(name for row in rows for name in [row["world"], *filter(None, row["against"].split("+"))]):
        steps = steps_of(program, world)
        median[world] = statistics.median(steps)
        print(f"{world:28}{median[world]:12.0f}{max(steps):12d}", flush=True)
    for row in rows:
        figure, limit = median[row["world"]], float(row["limit"])
        if row["against"]:
            figure /= sum(median[name] for name in row["against"].split("+"))
        good = figure <= limit
        said = f"{row['world']}{' / ' + row['against'] if row['against'] else ''}: {figure:.6g}, limit {row['limit']}"
        print(said + ("" if good else ": beyond it" + ("" if row["holds"] == "yes" else ", as known")))
        if good != (row["holds"] == "yes"):
            complaints.append(said + (": it holds now; say so in host_costs.csv" if good else ""))
    if check and complaints:
        sys.exit("host_costs: " + "\n".join(complaints))


main()
