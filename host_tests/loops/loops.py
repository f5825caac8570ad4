#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every loop of kernel/ and what bounds it.

    loops.py            checks: fails when a loop is in neither list, or a row of a list fits none
    loops.py --list     prints all loops with their bounds

A loop is counted when its header says `from; i < limit; ++i` (or <=, !=, a step, or downwards to a constant) and nothing in it changes i: limit, as it
stands in the source, has a row in limits.csv, which says for its file what it is at most (the same name may count something else in the next
file); numbers and constants of limits.h are their own bounds. A loop over an array (`for (x : array)`) needs no row. Any other loop has a row of
its own in loops.csv: file, header, times (how many loops of this file have this header), bound, reason.
"""
import collections
import csv
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))

Loop = collections.namedtuple("Loop", "file line header limit")


def without_comments(text):
    """The source, with as many lines, without comments and strings."""
    blank = lambda match: "\n" * match.group(0).count("\n") if match.group(0).startswith("/") else '""'
    return re.sub(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"", blank, text, flags=re.S)


def closing(text, at, pair):
    """The place after the bracket that closes the one at `at`."""
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] == pair[0]) - (text[i] == pair[1])
        if depth == 0:
            return i + 1
    raise ValueError("brackets that do not close")


def body_of(text, at):
    """The statement that begins at `at`."""
    while text[at].isspace():
        at += 1
    if text[at] == "{":
        return text[at:closing(text, at, "{}")]
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] in "({[") - (text[i] in ")}]")
        if depth == 0 and text[i] in ";}" or depth < 0:
            return text[at:i + 1]
    raise ValueError("a statement that does not end")


def changes(body, name):
    """True where a statement may change the variable."""
    n = re.escape(name)
    return bool(re.search(r"(\+\+|--|(?<![&\w])&)\s*%s\b|\b%s\s*(\+\+|--|[-+*/|&^%%]=|>>=|<<=|=(?!=))" % (n, n), body))


def limit_of(header, body):
    """What the counter of a counted loop stays below or reaches; "" for an array; None for other loops."""
    parts = header.split(";")
    if len(parts) == 1:
        return "" if re.search(r"[^:]:[^:]", header) else None
    if len(parts) != 3:
        return None
    begin = re.match(r"\s*(?:const\s+)?[\w:]+\s+(\w+)\s*=\s*(.+?)\s*$", parts[0], re.S)
    if not begin:
        return None
    name, start = begin.groups()
    step = parts[2].strip()
    up = re.match(r"(\+\+%s|%s \+= \w+)\b" % (name, name), step)
    down = re.match(r"(--%s|%s -= \w+)\b" % (name, name), step)
    if not (up or down) or changes(body, name) or ("," in step and changes(step.split(",", 1)[1], name)):
        return None
    for condition in re.split(r"\s*&&\s*", parts[1].strip()):
        bound = re.match(r"%s\s*(<=|<|!=|>=|>)\s*(.+)$" % name, condition, re.S)
        if bound and up and bound.group(1) in ("<", "<=", "!="):
            return " ".join(bound.group(2).split())
        if bound and down and bound.group(1) in (">", ">="):
            return " ".join(re.sub(r",.*", "", start, flags=re.S).split())
    return None


def loops_of(path):
    with open(path) as file:
        text = without_comments(file.read())
    name = os.path.relpath(path, ROOT)
    for match in re.finditer(r"\b(for|while)\s*\(|\bdo\s*\{", text):
        line = text.count("\n", 0, match.start()) + 1
        if match.group(0).startswith("do"):
            yield Loop(name, line, "do", None)
            continue
        at = match.end() - 1
        end = closing(text, at, "()")
        header = " ".join(text[at + 1:end - 1].split())
        if match.group(1) == "while":
            if text[end:].lstrip().startswith(";") and text[:match.start()].rstrip().endswith("}"):
                continue  # of do
            yield Loop(name, line, "while " + header, None)
        else:
            body = body_of(text, end)
            yield Loop(name, line, "for " + header, limit_of(header, body))


def rows_of(name):
    if "--without-lists" in sys.argv:
        return []  # for the test that what is not listed is noticed
    with open(os.path.join(os.path.dirname(HERE), "tables", name)) as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def main():
    paths = sorted(os.path.join(directory, name) for directory, _, names in os.walk(os.path.join(ROOT, "kernel")) for name in names if name.endswith((".h", ".cpp")))
    loops = [loop for path in paths for loop in loops_of(path)]
    limits = {(row["file"], row["limit"]): row["bound"] for row in rows_of("limits.csv")}
    others = {(row["file"], row["header"]): row for row in rows_of("loops.csv")}
    unknown, used = [], collections.Counter()
    for loop in loops:
        if loop.limit is None:
            key = (loop.file, loop.header)
            used[key] += 1
            bound = others[key]["bound"] + ": " + others[key]["reason"] if key in others else None
        elif loop.limit == "" or re.fullmatch(r"(?:\d+|lanes|[ +*-]|limits::\w+|sizeof\(?[ \w]+\)?)+", loop.limit):
            bound = loop.limit or "the array"
        else:
            key = (loop.file, loop.limit)
            used[key] += 1
            bound = limits.get(key)
        if bound is None:
            unknown.append("%s:%d: %s: %s" % (loop.file, loop.line, loop.header, "no row in loops.csv" if loop.limit is None else
                                             "no row in limits.csv for " + loop.limit))
        if "--list" in sys.argv:
            print("%s:%d: %s: %s" % (loop.file, loop.line, loop.header, bound))
    stale = ["limits.csv: %s: %s bounds no loop" % key for key in limits if not used[key]]
    for key, row in others.items():
        if used[key] != int(row["times"]):
            stale.append("loops.csv: %s: %s stands there %d times" % (*key, used[key]))
    counted = sum(loop.limit is not None for loop in loops)
    print("%d loops: %d counted, %d with a reason of their own" % (len(loops), counted, len(loops) - counted))
    if unknown or stale or not loops:
        sys.exit("\n".join(unknown + stale))


if __name__ == "__main__":
    main()
