#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""lines_test.py HOUSE: no line of C++ is longer than .clang-format says."""
import pathlib
import re
import sys

house = pathlib.Path(sys.argv[1])
limit = int(re.search(r"^ColumnLimit: (\d+)$", (house / ".clang-format").read_text(), re.M).group(1))
sources = [path for room in ("kernel", "platform", "host_tests", "fuzz") for path in (house / room).rglob("*") if path.suffix in (".h", ".cpp")]
assert sources, f"no sources in {house}"
long = [f"{path.relative_to(house)}:{number}: {len(line)} characters, the limit is {limit}" for path in sorted(sources)
        for number, line in enumerate(path.read_text().splitlines(), 1) if len(line) > limit]
print("\n".join(long))
sys.exit(1 if long else 0)
