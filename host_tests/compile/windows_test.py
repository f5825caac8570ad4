#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""windows_test.py COMPILER NM INCLUDE SOURCE SCRATCH: clang for a Windows target, without a header of Windows, compiles the kernel, without a word, with one lane
and with four, to an object that asks for nothing but memory to be copied and cleared. clang-cl is told of the floating-point contract by /clang:. Nothing is
linked, and nothing is run."""
import pathlib
import re
import subprocess
import sys

compiler, nm, include, source, scratch = sys.argv[1:6]
pathlib.Path(scratch).mkdir(parents=True, exist_ok=True)
house = pathlib.Path(__file__).resolve().parents[2]
contract = re.search(r"set\(flags (-fno-fast-math .*)\)", (house / "toolchains/flags.cmake").read_text(encoding="utf-8"))[1].split()
target = ["--target=x86_64-pc-windows-msvc", f"-I{include}", "-DINGOT_DOUBLE=0", "-DINGOT_INDEX_BITS=16", "-DINGOT_CALLS_HELPERS"]


def silently(*command):
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode != 0 or run.stderr:
        sys.exit(f"{' '.join(command)}\nended with {run.returncode}:\n{run.stderr}")
    return run.stdout


for lanes in (1, 4):
    flags = [*target, f"-DINGOT_LANES={lanes}"]
    made = f"{scratch}/kernel_{lanes}.obj"
    silently(compiler, *flags, *contract, "-std=c++17", "-ffreestanding", "-fno-exceptions", "-fno-rtti", "-Wall", "-Wextra", "-c", source, "-o", made)
    asked = set(silently(nm, "-u", made).split()) - {"U", "memcpy", "memset", "__chkstk", "_fltused"}  # the last two are the compiler's own
    if asked:
        sys.exit(f"{made} asks for {asked}")
silently(compiler, "--driver-mode=cl", *target, "-DINGOT_LANES=4", "/std:c++17", "/GR-", *(f"/clang:{flag}" for flag in [*contract, "-ffreestanding"]), "/Zs",
         "--", source)  # a path may begin as an option does: /W, /Users
