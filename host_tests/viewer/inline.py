#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes one page of the viewer's parts: inline.py --module viewer.wasm --table native_hashes.txt --out viewer.html

Module, table and scripts are packed together by LZMA and written in 91 signs; unpack.js, which is in the page as it is, takes them apart.
"""
import argparse
import lzma
import pathlib
import re

HERE = pathlib.Path(__file__).parent
SCRIPTS = ["engine.js", "exact.js", "gl.js", "page.js"]


def without_comments(script):
    """Lines that are a comment go, and the space before the others; what stands in a line stays."""
    lines = (line.strip() if "`" not in script else line.rstrip() for line in script.splitlines())
    return "\n".join(line for line in lines if line.strip() and not line.strip().startswith("//"))


def pack(data):
    filters = [{"id": lzma.FILTER_LZMA1, "preset": 9 | lzma.PRESET_EXTREME, "lc": 3, "lp": 0, "pb": 0, "dict_size": 1 << 21}]
    packed = lzma.compress(data, format=lzma.FORMAT_RAW, filters=filters)
    return in_91(packed), len(packed)


def in_91(data):
    """13 bits are two signs; a script's text has them as they are."""
    signs = [sign for sign in map(chr, range(32, 127)) if sign not in "'<\\^"]
    pairs, held, bits = [], 0, 0
    for byte in data + b"\0\0":
        held |= byte << bits
        bits += 8
        if bits >= 13:
            pairs.append(signs[(held & 8191) // 91] + signs[(held & 8191) % 91])
            held >>= 13
            bits -= 13
    return "".join(pairs)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--module", type=pathlib.Path, required=True)
    parser.add_argument("--table", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--most", type=int, default=250000, help="bytes that the page may have")
    of = parser.parse_args()

    module = of.module.read_bytes()
    table = of.table.read_text()
    script = "\n".join(without_comments((HERE / name).read_text()) for name in SCRIPTS)
    parts = [module, table.encode(), script.encode()]
    text, packed = pack(b"".join(parts))
    sizes = ", ".join(str(len(part)) for part in parts)
    loader = "{\n%s\nconst sizes = [%s], all = from_lzma(from_91('%s'), sizes[0] + sizes[1] + sizes[2]);\n%s\n}" % (
        without_comments((HERE / "unpack.js").read_text()), sizes, text,
        "const words = bytes => new TextDecoder().decode(bytes), script = document.createElement('script');\n"
        "script.textContent = words(all.subarray(sizes[0] + sizes[1]));\n"
        "document.head.append(script);\n"
        "begin(all.slice(0, sizes[0]), words(all.subarray(sizes[0], sizes[0] + sizes[1])));")
    page = (HERE / "viewer.html").read_text()
    page = re.sub(r"\n +", "\n", page).replace("/*LOADER*/", loader)
    of.out.write_text(page)
    size = len(page.encode())
    print(f"{of.out.name}: {size} bytes; module {len(module)}, all that is packed {sum(map(len, parts))} as {packed} bytes")
    if size > of.most:
        raise SystemExit(f"more than {of.most} bytes")


if __name__ == "__main__":
    main()
