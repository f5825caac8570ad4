#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes one page of the viewer's parts, or weighs modules as they are packed there:

    inline.py --module viewer.wasm --table native_hashes.txt --out viewer.html
    inline.py --weigh contacts.wasm viewer.wasm             fails where the first, contacts alone, takes more than --contacts-most

Module, table, scripts, style and what stands on the page are packed together by LZMA and written in 116 signs; unpack.js, which is in the page as it
is, takes them apart. Of the module operations and each sort of what follows them are packed one after the other: a fifteenth less. streams.js puts
them together again.
"""
import argparse
import collections
import lzma
import pathlib
import re

HERE = pathlib.Path(__file__).parent
SCRIPTS = ["streams.js", "engine.js", "exact.js", "gl.js", "page.js"]
STREAMS = ["head", "tail", "locals", "op", "get", "set", "align", "offset", "integer", "f32", "f64", "call", "branch", "rest"]


def without_comments(script):
    """Lines that are a comment go, and the space before the others; what stands in a line stays."""
    lines = (line.strip() if "`" not in script else line.rstrip() for line in script.splitlines())
    return "\n".join(line for line in lines if line.strip() and not line.strip().startswith("//"))


class Module:
    """The bytes of a module, taken apart. Source: WebAssembly Core Specification, 5.4 and 5.5: what follows which operation."""

    def __init__(self, data):
        self.data, self.at, self.streams = data, 0, collections.defaultdict(bytearray)
        self.at, begin = 8, 8
        while self.byte("head") != 10:  # the section of code
            begin, size = self.at, self.number("head")
            self.take("head", size)
        end = self.number("head")
        end += self.at
        for _ in range(self.number("head")):
            self.function()
        if self.at != end:
            raise SystemExit("the module's code does not end where it should")
        self.streams["head"][:0] = data[:8]
        self.take("tail", len(data) - end)

    def take(self, stream, count):
        self.streams[stream] += self.data[self.at:self.at + count]
        self.at += count

    def byte(self, stream):
        self.take(stream, 1)
        return self.data[self.at - 1]

    def number(self, stream):
        value, shift, byte = 0, 0, 128
        while byte & 128:
            byte = self.byte(stream)
            value |= (byte & 127) << shift
            shift += 7
        return value

    def function(self):
        """How long it is need not be written: it ends where its blocks do."""
        begin, size = self.at, self.number("none")
        if len(self.streams.pop("none")) != max(1, (size.bit_length() + 6) // 7):
            raise SystemExit("the length of a function has more digits than it needs: streams.js would write another module")
        end, depth = self.at + size, 1
        for _ in range(self.number("locals")):
            self.number("locals")
            self.byte("locals")
        while depth > 0:
            op = self.byte("op")
            depth += (op in (0x02, 0x03, 0x04)) - (op == 0x0b)
            self.operation(op)
        if self.at != end:
            raise SystemExit(f"the function at {begin} does not end where it should")

    def operation(self, op):
        if op in (0x02, 0x03, 0x04):
            self.byte("op")
        elif op in (0x0c, 0x0d):
            self.number("branch")
        elif op == 0x0e:
            for _ in range(self.number("branch") + 1):
                self.number("branch")
        elif op in (0x10, 0x11):
            self.number("call")
            if op == 0x11:
                self.number("call")
        elif op == 0x20:
            self.number("get")
        elif op in (0x21, 0x22):
            self.number("set")
        elif 0x28 <= op <= 0x3e:
            self.number("align")
            self.number("offset")
        elif op in (0x41, 0x42):
            self.number("integer")
        elif op == 0x43:
            self.take("f32", 4)
        elif op == 0x44:
            self.take("f64", 8)
        elif op in (0x23, 0x24):
            self.number("rest")
        elif op == 0xfc:
            which = self.byte("op")
            if which not in (10, 11):
                raise SystemExit(f"operation 0xfc {which}: streams.js does not know it")
            self.take("rest", 12 - which)
        elif not (op in (0x00, 0x01, 0x05, 0x0b, 0x0f, 0x1a, 0x1b) or 0x45 <= op <= 0xbf):
            raise SystemExit(f"operation {op:#x}: streams.js does not know it")


def pack(data):
    filters = [{"id": lzma.FILTER_LZMA1, "preset": 9 | lzma.PRESET_EXTREME, "lc": 3, "lp": 0, "pb": 0, "dict_size": 1 << 21}]
    packed = lzma.compress(data, format=lzma.FORMAT_RAW, filters=filters)
    return in_116(packed), len(packed)


def in_116(data):
    """Six bytes are seven signs of one byte each, which a page of any server and a script's text have as they are: all that ends no line, no string and
    no script, and is no 0, which HTML does not keep."""
    signs = [chr(code) for code in range(1, 127) if code not in (9, 10, 11, 12, 13, 26, 27) and chr(code) not in "'<\\"]
    text, base = [], len(signs)
    assert base == 116
    for at in range(0, len(data), 6):
        number = int.from_bytes(data[at:at + 6].ljust(6, b"\0"), "big")
        text.append("".join(signs[number // base**place % base] for place in range(6, -1, -1)))
    return "".join(text)


def packed_module(path):
    streams = Module(path.read_bytes()).streams
    return pack(b"".join(bytes(streams[name]) for name in STREAMS))[1]


def weigh(contacts, whole, most):
    sizes = [packed_module(path) for path in (contacts, whole)]
    print(f"packed: contacts, five shapes by both solvers, {sizes[0]} bytes, at most {most}; joints, levels and who walks {sizes[1] - sizes[0]}; "
          f"together {sizes[1]}")
    if sizes[0] > most:
        raise SystemExit(f"contacts take more than {most} bytes")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--module", type=pathlib.Path)
    parser.add_argument("--table", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--weigh", type=pathlib.Path, nargs=2)
    parser.add_argument("--contacts-most", type=int, default=105000, help="bytes that the module of contacts alone may have, packed")
    parser.add_argument("--most", type=int, default=250000, help="bytes that the page may have")
    of = parser.parse_args()
    if of.weigh:
        return weigh(*of.weigh, of.contacts_most)

    module = of.module.read_bytes()
    table = of.table.read_text()
    page = re.sub(r"\n +", "\n", (HERE / "viewer.html").read_text())
    before, style, between, body, after = re.fullmatch(r"(.*<style>\n)(.*)(</style>.*<body[^>]*>\n)(.*)(<script>\n/\*LOADER\*/.*)", page, re.S).groups()
    script = "\n".join(without_comments((HERE / name).read_text()) for name in SCRIPTS)
    streams = Module(module).streams
    parts = [*(bytes(streams[name]) for name in STREAMS), table.encode(), style.encode(), body.encode(), script.encode()]
    text, packed = pack(b"".join(parts))
    loader = "{\n%s\nconst sizes = %s;\nlet at = 0;\nconst all = from_lzma(from_116('%s'), %d), parts = sizes.map(size => all.subarray(at, at += size));\n%s\n}" % (
        without_comments((HERE / "unpack.js").read_text()), [len(part) for part in parts], text, sum(map(len, parts)),
        "const [table, style, body, words] = parts.slice(-4).map(bytes => new TextDecoder().decode(bytes)), script = document.createElement('script');\n"
        "document.querySelector('style').textContent = style;\n"
        "document.body.innerHTML = body;\n"
        "script.textContent = words;\n"
        "document.head.append(script);\n"
        "begin(joined(parts.slice(0, -4)), table);")
    page = before + between + "<p>One moment.</p>\n" + after.replace("/*LOADER*/", loader)
    of.out.write_text(page)
    size = len(page.encode())
    alone = pack(b"".join(parts[:-4]))[1]
    print(f"{of.out.name}: {size} bytes; module {len(module)}, alone packed {alone}; all that is packed {sum(map(len, parts))} as {packed} bytes")
    if size > of.most:
        raise SystemExit(f"more than {of.most} bytes")


if __name__ == "__main__":
    main()
