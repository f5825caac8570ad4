#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""standard_words_test.py <compiler> <include folder> <source>: with INGOT_STANDARD_CPP=1 no unit of the kernel has a word beyond C++17.

Reads what the preprocessor leaves of the kernel's own lines, for 1 and 4 lanes, in float and double; and that the same words are there without it,
so that a look at nothing is noticed.
"""
import re
import subprocess
import sys

WORDS = re.compile(r"__builtin_\w+|__attribute__|__extension__|__is_base_of|__asm__|\basm\b|__int128|__restrict|__typeof")


def words_of(compiler, include, source, lanes, double, standard):
    flags = ["-std=c++17", "-E", "-ffreestanding", "-I" + include, f"-DINGOT_LANES={lanes}", f"-DINGOT_DOUBLE={double}", f"-DINGOT_STANDARD_CPP={standard}"]
    text = subprocess.run([compiler, *flags, source], capture_output=True, text=True, check=True).stdout
    found, own = {}, False
    for line in text.splitlines():
        marker = re.match(r'# \d+ "([^"]*)"', line)
        if marker:
            own = "/kernel/" in marker[1] and not marker[1].startswith("/usr/")
        elif own:
            for word in WORDS.findall(line):
                found[word] = found.get(word, 0) + 1
    return found


def main():
    compiler, include, source = sys.argv[1:]
    broken = []
    for lanes in (1, 4):
        for double in (0, 1):
            if not words_of(compiler, include, source, lanes, double, 0):
                broken.append(f"{lanes} lanes, double {double}: no such word where they are allowed; is this the kernel?")
            for word, times in words_of(compiler, include, source, lanes, double, 1).items():
                broken.append(f"{lanes} lanes, double {double}: {word} {times} times")
    if broken:
        sys.exit("standard words: " + "\n  ".join(broken))


if __name__ == "__main__":
    main()
