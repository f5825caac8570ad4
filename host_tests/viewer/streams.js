// SPDX-License-Identifier: MIT
// Puts a module together from what inline.py took it apart into: operations, and each sort of what follows them.

function joined(parts) {
  const [head, tail, locals, op, get, set, align, offset, integer, f32, f64, call, branch, rest] = parts.map(bytes => ({bytes, at: 0}));
  const out = new Uint8Array(parts.reduce((sum, bytes) => sum + bytes.length, 5 * parts[2].length));
  let at = 0;
  const take = (from, count) => { while (count-- > 0) out[at++] = from.bytes[from.at++]; return out[at - 1]; };
  const number = from => {
    let value = 0, shift = 0, byte;
    do { byte = take(from, 1); value |= (byte & 127) << shift; shift += 7; } while (byte & 128);
    return value;
  };
  take(head, head.bytes.length);
  while (locals.at < locals.bytes.length) {
    const begin = at;
    for (let kinds = number(locals); kinds > 0; --kinds) { number(locals); take(locals, 1); }
    for (let depth = 1; depth > 0;) {
      const code = take(op, 1);
      if (code === 0x0b) --depth;
      else if (code >= 2 && code <= 4) { ++depth; take(op, 1); }
      else if (code === 0x0c || code === 0x0d) number(branch);
      else if (code === 0x0e) for (let targets = number(branch); targets >= 0; --targets) number(branch);
      else if (code === 0x10) number(call);
      else if (code === 0x11) { number(call); number(call); }
      else if (code === 0x20) number(get);
      else if (code === 0x21 || code === 0x22) number(set);
      else if (code >= 0x28 && code <= 0x3e) { number(align); number(offset); }
      else if (code === 0x41 || code === 0x42) number(integer);
      else if (code === 0x43) take(f32, 4);
      else if (code === 0x44) take(f64, 8);
      else if (code === 0x23 || code === 0x24) number(rest);
      else if (code === 0xfc) take(rest, 12 - take(op, 1));
    }
    const size = [];  // stands ahead of it
    for (let left = at - begin; ; left >>>= 7) {
      size.push(left < 128 ? left : left & 127 | 128);
      if (left < 128) break;
    }
    out.copyWithin(begin + size.length, begin, at);
    out.set(size, begin);
    at += size.length;
  }
  take(tail, tail.bytes.length);
  return out.slice(0, at);
}
