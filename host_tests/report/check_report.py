#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The promises of the report, looked up in the table it wrote: check_report.py DIR."""
import csv
import math
import os
import sys

COLUMNS = "suite,case,method,scalar,lanes,target,h,metric,value,unit".split(",")
ORDERS = {"listing1_euler": 1, "lie_midpoint": 2, "rk4_polar": 4, "moser_veselov_2": 2, "moser_veselov_4": 4, "moser_veselov_6": 6,
          "moser_veselov_8": 8, "moser_veselov_10": 10, "symmetric_top_splitting_2": 2, "symmetric_top_splitting_6": 6}


def main(out):
    with open(os.path.join(out, "report.csv"), newline="") as file:
        reader = csv.DictReader(file)
        faults = [] if reader.fieldnames == COLUMNS else [f"columns are {reader.fieldnames}"]
        rows = list(reader)
    if len({tuple(row[column] for column in COLUMNS[:8]) for row in rows}) != len(rows):
        faults.append("two rows say the same")
    by_lanes = {}
    for row in rows:
        if row["suite"] in ("rotation", "contact") and row["unit"] not in ("ns", "us", "bytes"):
            by_lanes.setdefault(tuple(row[column] for column in ("case", "method", "scalar", "h", "metric")), set()).add(row["value"])
    faults += [f"differs between lanes: {key}" for key, values in by_lanes.items() if len(values) > 1]
    for suite in ("rotation", "driven", "drift", "throughput", "contact", "effort", "simbenchmark", "levels", "control", "mcu"):
        if not any(row["suite"] == suite for row in rows):
            faults.append(f"no rows of {suite}")
    for row in rows:
        if not math.isfinite(float(row["value"])):
            faults.append(f"not finite: {row}")

    def value(case, method, scalar, rate, metric="attitude_error", suite="rotation"):
        found = [float(row["value"]) for row in rows if row["suite"] == suite and row["case"] == case and row["method"] == method
                 and row["scalar"] == scalar and row["metric"] == metric and (rate is None or abs(float(row["h"]) * rate - 1) < 1e-9)]
        if not found:
            faults.append(f"no {metric} of {case}, {method}, {scalar}, {rate} Hz")
            return math.nan
        return found[0]

    def promise(what, measured, bound):
        print(f"{what}: {measured:.2e}, promised {bound:.1g}")
        if not measured <= bound:
            faults.append(f"{what}: {measured:.3e} is above {bound:.1g}")

    for rate in (15, 60):
        promise(f"book, double, {rate} Hz", value("book", "default", "double", rate), 1e-12)
    for rate in (15, 30, 60):
        promise(f"book, float, {rate} Hz", value("book", "default", "float", rate), 1e-5)
    for rate in (15, 60):  # 3.7e-4 at 30 Hz; 1/15 s and its halves, rounded to float, make 2.5e-4 rad of an hour at all three
        promise(f"book, one hour, float, {rate} Hz", value("book_hour", "default", "float", rate), 3e-4)
    promise("dzhanibekov, double, 15 Hz", value("dzhanibekov", "default", "double", 15), 1e-5)
    promise("chaotic top, order 4, 64 Hz", value("asymmetric_chaotic", "blanes_moan_4", "double", 64, suite="driven"), 1e-4)
    promise("chaotic top, commutator-free, 64 Hz", value("asymmetric_chaotic", "commutator_free_4", "double", 64, suite="driven"), 1e-4)
    promise("looping top, default, 64 Hz", value("looping", "kick_drift_kick", "double", 64, suite="driven"), 2e-3)
    for scalar in ("float", "double"):
        def contact(case, metric):
            return value(case, "default", scalar, 60, metric, "contact")
        promise(f"cube on a slope, {scalar}, creeps by mm", contact("incline_mu07", "creep"), 1e-3)
        promise(f"cube that slides, {scalar}, distance error in %", contact("incline_mu04", "distance_error"), 1e-3)
        promise(f"ball with e = 0.5, {scalar}, rests off 1.916 s by", abs(contact("bounce_e05", "rest_time") - 3 * math.sqrt(4 / 9.81)), 2 / 60)
        promise(f"tower of 20, {scalar}, falls short of 60 s by", 60 - contact("tower_20", "stood"), 1e-9)
        promise(f"tower of 20, {scalar}, sinks by mm", contact("tower_20", "sink"), 0.2)
    for case, scalar, bound in (("rolling_diagonal", "double", 5.7e-9), ("rolling_along_y", "double", 5.7e-9), ("bouncing", "float", 1.9e-2), ("bouncing", "double", 1.9e-2),
                                ("666", "float", 1.35e-4), ("666", "double", 1.35e-4), ("elastic_666", "float", 8.4), ("elastic_666", "double", 8.4)):
        promise(f"SimBenchmark, {case}, {scalar}, 1 ms", value(f"simbenchmark_{case}", "default", scalar, 1000, "error", "simbenchmark"), bound)
    for metric, bound in (("way_error", 1e-3), ("speed_error", 1e-3), ("hop", 1e-4), ("impulse_error", 1e-2)):
        promise(f"levels, {metric}, the worst", max((float(row["value"]) for row in rows if row["suite"] == "levels" and row["metric"] == metric), default=math.nan), bound)
    promise("ball with e = 1, double, energy", value("bounce_e1", "default", "double", 60, "energy_error", "contact"), 1e-6)
    for method, order in ORDERS.items():
        measured = value("book", method, "double", None, "order")
        promise(f"order of {method}, {order} but", abs(measured - order), 0.3)
    for case, bound in (("brick", 1e-9), ("water", 1e-9), ("slow", 1e-9), ("near_symmetric", 1e-9), ("oblate", 1e-9), ("prolate", 1e-9), ("sphere", 1e-11), ("near_separatrix", 1e-2)):
        promise(f"{case}, double, 60 Hz", value(case, "default", "double", 60), bound)
    for case, bound in (("needle", 1e-5), ("disc", 1e-9), ("fast", 1e-2)):
        promise(f"{case}, double, 64 Hz", value(case, "default", "double", 64), bound)
    for row in rows:
        if row["metric"] == "flips" and row["case"] == "dzhanibekov" and row["method"] == "default" and row["scalar"] == "double":
            promise("flips of dzhanibekov missed", abs(float(row["value"]) - value("dzhanibekov", "default", "double", None, "flips_of_table")), 0)
        if row["metric"] == "energy_error" and row["suite"] == "drift" and row["method"] == "default":
            if not float(row["value"]) <= (1e-11 if row["scalar"] == "double" else 1e-5):
                faults.append(f"energy: {row}")
        if row["metric"] == "orthogonality" and row["method"] == "default" and (row["case"] == "book" or row["suite"] == "drift"):
            if not float(row["value"]) <= (1e-14 if row["scalar"] == "double" else 3e-7):
                faults.append(f"orthogonality: {row}")
    for name in ("report.md", "index.html"):
        with open(os.path.join(out, name), encoding="utf-8") as file:
            text = file.read()
        if "Free rotation" not in text:
            faults.append(f"{name} has no table of the methods")
        # Self-contained: nothing is fetched when the page is opened.
        faults += [f"{name} asks for {word}" for word in ('src="', "src='", "<script", "<link", "@import", "url(http") if word in text]
    for fault in faults:
        print("report:", fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
