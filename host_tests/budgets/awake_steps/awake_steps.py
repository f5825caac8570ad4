#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a step costs beside bodies that sleep, in instructions of the host.

    awake_steps.py <awake_steps> [--steps 60] [scene ...]

Counts every call of counted_step() by valgrind's callgrind, and prints for each scene the median and the worst step. The program is a target of the
host presets: `cmake --build <build> --target awake_steps`, in Release, float, 4 lanes.
"""
import argparse
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

SCENES = ("asleep", "apart", "columns", "block", "64_alone", "64_among_60000")


def counted(program, scene, steps):
    """Instructions of each step of a scene, and the last line that the program printed."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out"
        command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", "--toggle-collect=counted_step", "--dump-after=counted_step",
                   program, scene, str(steps)]
        run = subprocess.run(command, capture_output=True, text=True, check=True)
        numbers = []
        for file in pathlib.Path(folder).glob("out.*"):
            found = re.search(r"^(?:totals|summary): (\d+)", file.read_text(), re.M)
            if found and int(found[1]):
                numbers.append((int(file.name.rsplit(".", 1)[1]), int(found[1])))
        return [number for _, number in sorted(numbers)], run.stdout.splitlines()[-1]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("scenes", nargs="*", default=SCENES)
    parser.add_argument("--steps", type=int, default=60)
    parser.add_argument("--all", action="store_true", help="prints every step")
    arguments = parser.parse_intermixed_args()
    for scene in arguments.scenes:
        numbers, last = counted(arguments.program, scene, arguments.steps)
        if len(numbers) != arguments.steps:
            sys.exit(f"{scene}: {len(numbers)} steps were counted of {arguments.steps}")
        print(f"{scene:16} median {statistics.median(numbers):>12,.0f} worst {max(numbers):>12,}   {last}")
        if arguments.all:
            print(*numbers)
        sys.stdout.flush()


if __name__ == "__main__":
    main()
