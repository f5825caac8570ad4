#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""traits_test.py SCENE FLIPS: each trait of Scene in SCENE has a row in FLIPS, and each row a trait."""
import pathlib
import re
import sys

scene, flips = (pathlib.Path(path).read_text() for path in sys.argv[1:])
scene = re.sub(r"//.*", "", scene)
members = re.search(r"^struct Scene \{\n(.*?)^\};", scene, re.M | re.S)[1]
traits = re.findall(r"^    (?:static constexpr \w+|using)\s+(\w+)\s*=", members, re.M)
rows = re.findall(r"^(?:FLIP|SAME)\((\w+),", flips, re.M)
declared = len(re.findall(r";", members))
wrong = [f"{trait}: no row in {sys.argv[2]}" for trait in traits if trait not in rows]
wrong += [f"{row}: no trait of Scene" for row in sorted(set(rows)) if row not in traits]
wrong += [f"{declared} members of Scene, of which {len(traits)} are seen as traits"] if declared != len(traits) else []
print("\n".join(wrong))
sys.exit(1 if wrong or not traits else 0)
