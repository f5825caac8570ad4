#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""initialised_test.py HOUSE: every member of every struct that a user makes or gets has an initialiser, so `BodyState s;` is what `BodyState s{};` is.

Vectors and matrices themselves have none: they are numbers, as a float is.
"""
import pathlib
import re
import sys

# Headers of which users see structs; those named, or all.
PUBLIC = {
    "base/ids.h": None, "base/report.h": ["StepReport"], "base/status.h": ["Result"], "body/check_body.h": ["BodyState"],
    "body/mass_properties.h": ["MassDistribution", "MassProperties", "MeshTriangle"], "body/user_frame.h": None,
    "broad_phase/body_filter.h": ["BodyFilter"], "events/contact_events.h": ["Event", "EventView"], "impulse/impulse.h": None,
    "motion/force_fields.h": None, "mover/mover.h": None, "query/query_filter.h": None, "shape/compound.h": ["ShapeDef", "ShapePlace"], "shape/convex_hull.h": None,
    "shape/placed_shape.h": None, "shape/shapes.h": None, "world/body_def.h": None, "world/world_contacts.h": ["ContactInfo", "OverlapInfo"],
}
MEMBER = re.compile(r"^ {4}(?: {4})?(?!using|static|template|friend|return|if|for)(?:const )?[\w:]+(?:<[^>]*>)?[ *]+(\w[^();]*|\w+\[[^;]*\]);$")

house = pathlib.Path(sys.argv[1])
wrong, seen = [], 0
for header, names in PUBLIC.items():
    path = house / "kernel" / header
    if not path.exists():
        continue  # a house of a few files, to see the test fail
    struct = None
    for number, line in enumerate(path.read_text().splitlines(), 1):
        begin = re.match(r"(?:struct|class) (?:\[\[nodiscard\]\] )?(\w+)[^;]*\{$", line)
        if begin:
            struct = begin[1]
        elif line.startswith("}"):
            struct = None
        elif struct and (names is None or struct in names):
            member = MEMBER.match(re.sub(r"\{[^}]+\}", "{}", line.split("//")[0].rstrip()))
            seen += bool(re.search(r"(\{\}| = [^;]+);", line))
            if member and any("{" not in name and "=" not in name for name in member[1].split(",") if "[" not in member[1] or "{}" not in member[1]):
                wrong.append(f"{header}:{number}: {struct}: {member[1]} has no initialiser")
print("\n".join(wrong))
sys.exit(1 if wrong or not seen else 0)
