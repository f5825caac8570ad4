#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""contract_test.py COMPILER OBJDUMP SCRATCH [--brief]: for a core that fuses a * b + c unless it is told not to, and without a flag, a user's unit of the
Arduino form fuses nothing. It does where the pragma is taken out, or what friends of templates need beside it, which shows that the test sees; not in brief.
The golden hashes of all units are compared by golden.arduino_* of the preset cortex-m4f."""
import pathlib
import re
import subprocess
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "toolchains"))
import bundle  # noqa: E402

COMPILER, OBJDUMP, SCRATCH = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
M4F = ["-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16", "-std=gnu++17", "-fno-exceptions", "-fno-rtti"]


def fused(name, unit, level):
    object_file = SCRATCH / "unit.o"
    subprocess.run([COMPILER, *M4F, level, f"-I{SCRATCH / name}", "-x", "c++", "-c", unit, "-o", object_file], check=True)
    listing = subprocess.run([OBJDUMP, "-d", object_file], check=True, capture_output=True, text=True).stdout
    return len(re.findall(r"\bvfn?m[as]\.f32\b", listing))


def mutated(name, pattern):
    """A copy of what own.cpp includes without what matches."""
    text, count = re.subn(pattern, "", (SCRATCH / "kept/ingot/ingot.h").read_text(encoding="utf-8"))
    assert count > 0, pattern
    (SCRATCH / name / "ingot").mkdir(parents=True, exist_ok=True)
    (SCRATCH / name / "ingot/ingot.h").write_text(text, encoding="utf-8")
    return name


bundle.write_bundle(str(SCRATCH / "kept/ingot"), flat=True, keeps=True)
own = HERE / "own.cpp"
counts = {
    "a user's unit at -O3": fused("kept", own, "-O3"),
    "a user's unit at -Os": fused("kept", own, "-Os"),
}
without = {} if "--brief" in sys.argv else {
    "without the pragma, at -O3": fused(mutated("bare", r"#pragma GCC optimize.*"), own, "-O3"),
    "without what friends of templates need, at -Os": fused(mutated("friendless", r"__attribute__\(\(optimize\(.*?\)\)\) "), own, "-Os"),
}
print(counts, without)
sys.exit(f"fused where nothing should be, or not where it should: {counts} {without}" if any(counts.values()) or not all(without.values()) else 0)
