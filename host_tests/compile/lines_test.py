#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""lines_test.py HOUSE: no line of C++ is longer than .clang-format says, and no assertion of GoogleTest stands behind an if without braces: it has an
else of its own, of which gcc warns, and clang, which compiles the tests in brief, does not."""
import pathlib
import re
import sys

house = pathlib.Path(sys.argv[1])
limit = int(re.search(r"^ColumnLimit: (\d+)$", (house / ".clang-format").read_text(), re.M).group(1))
sources = [path for room in ("kernel", "platform", "host_tests", "fuzz") for path in (house / room).rglob("*") if path.suffix in (".h", ".cpp")]
assert sources, f"no sources in {house}"
long = [f"{path.relative_to(house)}:{number}: {len(line)} characters, the limit is {limit}" for path in sorted(sources)
        for number, line in enumerate(path.read_text().splitlines(), 1) if len(line) > limit]
# A condition of a line, and at its end, or on the next line, the assertion.
bare = re.compile(r"^[ \t]*if \([^;{}\n]*\)\s+(?:EXPECT|ASSERT)_[A-Z_]+\(", re.M)
texts = {path: path.read_text() for path in sorted(sources) if "host_tests" in path.parts}
bare_ifs = [f"{path.relative_to(house)}:{text.count(chr(10), 0, match.start()) + 1}: an assertion behind an if wants braces"
            for path, text in texts.items() for match in bare.finditer(text)]
print("\n".join(long + bare_ifs))
sys.exit(1 if long or bare_ifs else 0)
