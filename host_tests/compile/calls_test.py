#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""No function of the kernel calls itself, by whatever way round, or through a pointer, or has a frame of no fixed size.

    calls_test.py kernel.cpp.ci scenes.cpp.ci ...

Reads what gcc writes with -fcallgraph-info=su. At -O0 nothing is inlined and no tail call becomes a loop: the graph is that of
the source. budgets/call_graph.py measures what a firmware needs; here every function counts, called or not.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "budgets"))
sys.dont_write_bytecode = True
from call_graph import read_compiler_graphs  # noqa: E402


def cycle_in(calls):
    """A way from a function back to it, as names; None if there is none."""
    done, path = set(), []

    def visit(name):
        if name in path:
            return path[path.index(name):] + [name]
        if name in done:
            return None
        path.append(name)
        for callee in sorted(calls.get(name, ())):
            found = visit(callee)
            if found:
                return found
        path.pop()
        done.add(name)
        return None

    for name in sorted(calls):
        found = visit(name)
        if found:
            return found
    return None


def main():
    sys.setrecursionlimit(10000)
    frames, faults, calls = read_compiler_graphs(sys.argv[1:])
    if len(frames) < int(os.environ.get("INGOT_FUNCTIONS_AT_LEAST", "1")):
        sys.exit("calls: only %d functions in %d graphs" % (len(frames), len(sys.argv) - 1))
    # A frame aligned for vectors wider than the stack's own alignment is dynamic by no more than that alignment.
    aligned = {"has a frame that is dynamic,bounded"}
    broken = ["%s %s" % (name, " and ".join(sorted(why - aligned))) for name, why in sorted(faults.items()) if why - aligned]
    cycle = cycle_in(calls)
    if cycle:
        broken.append("recursion: " + " -> ".join(cycle))
    if broken:
        sys.exit("calls: " + "\n  ".join(broken))
    print("%d functions, no cycle, no pointer, every frame of a fixed size" % len(frames))


if __name__ == "__main__":
    main()
