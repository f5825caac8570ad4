#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a body and a manifold take of RAM: a table of the README.

    capacities.py PROGRAM --check     PROGRAM is capacities_main.cpp; fails where the README says otherwise
    capacities.py PROGRAM --update    writes it
"""
import pathlib
import subprocess
import sys

README = pathlib.Path(__file__).resolve().parents[3] / "README.md"
BEGIN, END = "<!-- written by capacities.py -->\n", "<!-- end of capacities -->\n"


def table(program):
    rows = [line.rsplit(",", 2) for line in subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines()]
    lines = ["| a world of | a body | a manifold, or a contact of `max_contacts` |", "| --- | ---: | ---: |"]
    return "\n".join(lines + [f"| {name} | {body} | {manifold} |" for name, body, manifold in rows]) + "\n"


def main():
    program, action = sys.argv[1], sys.argv[2]
    page = README.read_text()
    begin, end = page.index(BEGIN) + len(BEGIN), page.index(END)
    new = page[:begin] + table(program) + page[end:]
    if action == "--update":
        README.write_text(new)
    elif new != page:
        sys.exit("capacities: the README is stale: cmake --build <a host build> --target update_capacities")


main()
