#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Worst-case stack of a function of a linked firmware, and proof that there is one.

    call_graph.py --root step_of_scene firmware.elf --objects moser_veselov_6.cpp.obj step_of_scene.cpp.obj ...

Frames come from the compiler for all that it compiled (-fcallgraph-info=su leaves them beside the objects), and from the
disassembly for what came compiled: the soft-float helpers of libgcc, memcpy and memset. Calls come from both. The compiler's
graph knows a call through a pointer for what it is; the disassembly knows the helpers that the assembler writes in by itself.

Fails on what has no bound: recursion, a frame of no fixed size, a call through a pointer, a stack pointer moved by an
instruction not known here.
"""
import argparse
import bisect
import os
import re
import subprocess
import sys

WORD_BYTES = 4
DOUBLE_WORD_BYTES = 8
INDIRECT_CALL = "__indirect_call"  # name of the node in the compiler's graph


class Unbounded(Exception):
    """The stack has no bound that can be computed; the text says why."""


class Function:
    """One function of the firmware. Frame in bytes, return address included where the function saves it."""

    def __init__(self, address, name):
        self.address = address
        self.name = name
        self.aliases = set()  # other names: where two functions are alike the compiler keeps one, and reports that one alone
        self.frame = 0
        self.callees = set()  # addresses
        self.faults = set()  # why its stack has no bound
        self.compiled = False  # the compiler told its frame
        self.falls_through = True  # into the function behind it


def registers_in(operands):
    """How many registers a list such as {r4, r5-r7, lr} names."""
    count = 0
    for part in re.search(r"\{([^}]*)\}", operands)[1].split(","):
        first, _, last = part.strip().partition("-")
        count += int(last[1:]) - int(first[1:]) + 1 if last else 1
    return count


def push_bytes(mnemonic, operands):
    """Bytes by which an instruction lowers the stack pointer; None if it does so in a way not known here."""
    base = mnemonic.split(".")[0]
    if base == "push" or (base in ("stmdb", "stmfd") and operands.startswith("sp!")):
        return WORD_BYTES * registers_in(operands)
    if base == "vpush" or (base == "vstmdb" and operands.startswith("sp!")):
        return registers_in(operands) * (DOUBLE_WORD_BYTES if "{d" in operands else WORD_BYTES)
    by_number = re.match(r"sp, (?:sp, )?#(\d+)$", operands)
    if by_number and base in ("sub", "subs", "subw", "add", "adds", "addw"):
        return int(by_number[1]) if base.startswith("sub") else 0
    pre_indexed = re.search(r"\[sp, #-(\d+)\]!$", operands)
    if base.startswith("str") and pre_indexed:
        return int(pre_indexed[1])
    if base in ("ldmia", "vldmia") and operands.startswith("sp!"):
        return 0
    writes_sp = re.match(r"sp[,!]", operands) or re.search(r"\[sp.*\]!$", operands)
    return None if writes_sp else 0


def return_register(mnemonic, operands, before):
    """The register that holds the return address behind an instruction, or None. Where arguments were spilled, Thumb-1 returns by
    `pop {r3}; add sp, #n; bx r3`: no call through a pointer."""
    popped = re.match(r"\{(r\d+)\}$", operands) if mnemonic == "pop" else None
    if popped:
        return popped[1]
    return before if mnemonic == "add" and operands.startswith("sp, ") else None


def read_disassembly(objdump, elf):
    """All functions of a firmware by address, with frames and calls as the instructions have them."""
    command = [objdump, "-d", "--no-show-raw-insn", elf]
    text = subprocess.run(command, check=True, stdout=subprocess.PIPE, universal_newlines=True).stdout
    headers = re.compile(r"^([0-9a-f]+) <(.+)>:$", re.M)
    functions = {int(m[1], 16): Function(int(m[1], 16), m[2]) for m in headers.finditer(text)}
    symbols = subprocess.run([objdump, "-t", elf], check=True, stdout=subprocess.PIPE, universal_newlines=True).stdout
    for symbol in re.finditer(r"^([0-9a-f]+) .* F \S+\t[0-9a-f]+ (?:\.hidden )?(\S+)$", symbols, re.M):
        if int(symbol[1], 16) in functions:
            functions[int(symbol[1], 16)].aliases.add(symbol[2])
    starts = sorted(functions)
    function = None
    returns_by = None
    for line in text.splitlines():
        header = headers.match(line)
        if header:
            function = functions[int(header[1], 16)]
            returns_by = None
            continue
        instruction = re.match(r"\s*[0-9a-f]+:\t(\S+)(?:\t([^;@]*))?", line)
        if not instruction or function is None or instruction[1].startswith("."):
            continue
        mnemonic, operands = instruction[1], (instruction[2] or "").strip()
        base = mnemonic.split(".")[0]

        pushed = push_bytes(mnemonic, operands)
        if pushed is None:
            function.faults.add("moves the stack pointer by `%s %s`" % (mnemonic, operands))
        function.frame += pushed or 0

        # A branch out of the function is a call too: the last one, made as a jump. (libgcc also jumps into the middle of a
        # neighbour: its whole frame is taken.) `mov pc, rN` and tbb jump by a table within the function; GCC calls through
        # a pointer by blx, and as the last act by bx.
        target = re.match(r"(?:r\d+, )?([0-9a-f]+) <", operands)
        if target and base[0] in "bc":
            destination = int(target[1], 16)
            callee = starts[bisect.bisect_right(starts, destination) - 1]
            # Within itself a Cortex-M0 takes bl for a long jump; a call of itself begins at the beginning.
            if callee != function.address or (base == "bl" and destination == callee):
                function.callees.add(callee)
        elif base == "blx" or (base == "bx" and operands not in ("lr", returns_by)):
            function.faults.add("calls through a pointer: `%s %s`" % (mnemonic, operands))
        elif base == "bl":
            function.faults.add("calls what has no name: `%s %s`" % (mnemonic, operands))
        returns_by = return_register(base, operands, returns_by)
        if base != "nop":  # padding, behind the last instruction
            returns = base in ("pop", "ldmia") and re.search(r"\bpc\b", operands)
            function.falls_through = not (returns or base in ("b", "bx", "udf") or operands.startswith("pc,"))
    return functions


def read_compiler_graphs(objects):
    """Frames and calls that the compiler reports, by name. A name that two files use has the larger frame."""
    frames, faults, calls = {}, {}, {}
    plain = lambda title: title.rsplit(":", 1)[-1]  # local functions are called file:name
    for path in objects:
        with open(os.path.splitext(path)[0] + ".ci", encoding="utf-8") as graph:
            for line in graph:
                node = re.match(r'node: \{ title: "([^"]+)" label: "[^"]*\\n(\d+) bytes \(([^)]*)\)', line)
                if node:
                    name = plain(node[1])
                    frames[name] = max(frames.get(name, 0), int(node[2]))
                    if node[3] != "static":
                        faults.setdefault(name, set()).add("has a frame that is " + node[3])
                edge = re.match(r'edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"', line)
                if edge:
                    calls.setdefault(plain(edge[1]), set()).add(plain(edge[2]))
    for name, callees in calls.items():
        if INDIRECT_CALL in callees:
            faults.setdefault(name, set()).add("calls through a pointer")
    return frames, faults, calls


def read_firmware(objdump, elf, objects):
    """All functions by address, the compiler's word going before the disassembly's."""
    functions = read_disassembly(objdump, elf)
    frames, faults, calls = read_compiler_graphs(objects)
    addresses = sorted(functions)
    by_name = {}
    for address in addresses:
        for name in functions[address].aliases | {functions[address].name}:
            by_name.setdefault(name, set()).add(address)
    for address, following in zip(addresses, addresses[1:] + [None]):
        function = functions[address]
        known = [name for name in [function.name] + sorted(function.aliases) if name in frames]
        if known:
            function.compiled = True
            function.frame = frames[known[0]]
            # What moves the stack pointer is the compiler's business: large frames are beyond `sub sp, #n` on a Cortex-M0.
            function.faults = {fault for fault in function.faults if "stack pointer" not in fault}
            function.faults |= faults.get(known[0], set())
            # A callee without an address was inlined, or dropped by the linker.
            for callee in calls.get(known[0], ()):
                function.callees |= by_name.get(callee, set())
        elif function.falls_through and following is not None:
            function.callees.add(following)
    return functions


def deepest(functions, address, path=(), known=None):
    """Bytes and addresses of the deepest way down from a function."""
    known = {} if known is None else known
    function = functions[address]
    if address in path:
        cycle = path[path.index(address):] + (address,)
        raise Unbounded("recursion: " + " -> ".join(functions[a].name for a in cycle))
    if function.faults:
        raise Unbounded("%s %s" % (function.name, " and ".join(sorted(function.faults))))
    if address not in known:
        below = [deepest(functions, callee, path + (address,), known) for callee in sorted(function.callees)]
        bytes_below, way = max(below, default=(0, ()))
        known[address] = (function.frame + bytes_below, (address,) + way)
    return known[address]


def worst_stack(objdump, elf, objects, root):
    """Bytes that a call of `root` needs, its own frame included, and the deepest way as (frame, name, compiled)."""
    functions = read_firmware(objdump, elf, objects)
    roots = [address for address, function in functions.items() if function.name == root]
    if len(roots) != 1:
        raise Unbounded("%d functions called %s in %s" % (len(roots), root, elf))
    total, way = deepest(functions, roots[0])
    return total, [(functions[a].frame, functions[a].name, functions[a].compiled) for a in way]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--objdump", default="arm-none-eabi-objdump")
    parser.add_argument("--root", required=True, help="symbol of the function")
    parser.add_argument("elf")
    parser.add_argument("--objects", nargs="*", default=[], help="objects compiled with -fcallgraph-info=su")
    arguments = parser.parse_args()
    try:
        total, way = worst_stack(arguments.objdump, arguments.elf, arguments.objects, arguments.root)
    except Unbounded as why:
        sys.exit("stack without bound: %s" % why)
    for frame, name, compiled in way:
        print("%6d  %s%s" % (frame, name, "" if compiled else "   (from its disassembly)"))
    print("%6d  bytes in all" % total)


if __name__ == "__main__":
    main()
