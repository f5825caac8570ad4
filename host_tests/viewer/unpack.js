// SPDX-License-Identifier: MIT
// Takes apart what inline.py packed: text of 116 signs, seven of which are six bytes, then LZMA, which is a quarter smaller than gzip.
// Source: "LZMA specification", I. Pavlov, public domain.

/// Signs of one byte, but for 0, what ends lines, files and scripts: tabs and line feeds, 26, 27, ', < and \ .
function from_116(text) {
  const out = new Uint8Array(text.length / 7 * 6), value = new Uint8Array(127), skipped = [9, 10, 11, 12, 13, 26, 27, 39, 60, 92];
  for (let code = 1, next = 0; code < 127; ++code) if (!skipped.includes(code)) value[code] = next++;
  for (let i = 0, at = 0; i < text.length; at += 6) {
    let number = 0;
    for (const end = i + 7; i < end; ++i) number = number * 116 + value[text.charCodeAt(i)];
    for (let byte = 5, rest = number; byte >= 0; --byte, rest = Math.floor(rest / 256)) out[at + byte] = rest % 256;
  }
  return out;
}

/// data: from the first byte of the range coder on. lc literal bits of the byte before, no others; size: bytes that come out.
function from_lzma(data, size, lc = 3) {
  const out = new Uint8Array(size), half = n => new Uint16Array(n).fill(1024), HALF = 1 << 11;
  let at = 5, code = 0, range = -1 >>> 0, done = 0, state = 0, rep = [0, 0, 0, 0];
  for (let i = 1; i < 5; ++i) code = (code << 8 | data[i]) >>> 0;
  const more = () => { if (range < 0x1000000) { range = range << 8 >>> 0; code = (code << 8 | data[at++]) >>> 0; } };
  const bit = (p, i) => {
    const bound = (range >>> 11) * p[i];
    if (code < bound) { range = bound; p[i] += HALF - p[i] >> 5; more(); return 0; }
    range -= bound; code -= bound; p[i] -= p[i] >> 5; more(); return 1;
  };
  const tree = (p, bits, from = 0) => { let m = 1; for (let i = 0; i < bits; ++i) m = m << 1 | bit(p, from + m); return m - (1 << bits); };
  const reverse = (p, bits, from = 0) => {
    let m = 1, n = 0;
    for (let i = 0; i < bits; ++i) {
      const b = bit(p, from + m);
      m = m << 1 | b;
      n |= b << i;
    }
    return n;
  };
  const literal = half(0x300 << lc), is_match = half(12), is_rep = half(12), is_rep0 = half(12), is_long = half(12), is_rep1 = half(12),
        is_rep2 = half(12);
  const lengths = () => ({choice: half(2), low: half(8), middle: half(8), high: half(256)}), match_length = lengths(), rep_length = lengths();
  const length = l => bit(l.choice, 0) ? bit(l.choice, 1) ? 16 + tree(l.high, 8) : 8 + tree(l.middle, 3) : tree(l.low, 3);
  const slots = [half(64), half(64), half(64), half(64)], special = half(128), align = half(16);
  while (done < size) {
    if (!bit(is_match, state)) {
      const from = 0x300 * ((done ? out[done - 1] : 0) >> 8 - lc);
      let m = 1;
      if (state >= 7) {
        let match = out[done - rep[0] - 1];
        do {
          const b = match >> 7 & 1, got = bit(literal, from + (1 + b << 8) + m);
          match <<= 1;
          m = m << 1 | got;
          if (b !== got) break;
        } while (m < 256);
      }
      while (m < 256) m = m << 1 | bit(literal, from + m);
      out[done++] = m;
      state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
      continue;
    }
    let count;
    if (bit(is_rep, state)) {
      if (!bit(is_rep0, state)) {
        if (!bit(is_long, state)) { state = state < 7 ? 9 : 11; out[done] = out[done - rep[0] - 1]; ++done; continue; }
      } else {
        let distance;
        if (!bit(is_rep1, state)) distance = rep[1];
        else {
          if (!bit(is_rep2, state)) distance = rep[2];
          else { distance = rep[3]; rep[3] = rep[2]; }
          rep[2] = rep[1];
        }
        rep[1] = rep[0];
        rep[0] = distance;
      }
      count = length(rep_length);
      state = state < 7 ? 8 : 11;
    } else {
      rep = [0, rep[0], rep[1], rep[2]];
      count = length(match_length);
      state = state < 7 ? 7 : 10;
      const slot = tree(slots[Math.min(count, 3)], 6);
      if (slot < 4) rep[0] = slot;
      else {
        const bits = (slot >> 1) - 1, base = (2 | slot & 1) << bits;
        if (slot < 14) rep[0] = base + reverse(special, bits, base - slot);
        else {
          let n = 0;
          for (let i = 0; i < bits - 4; ++i) {
            range = range >>> 1;
            const b = code >= range ? 1 : 0;
            if (b) code -= range;
            n = n << 1 | b;
            more();
          }
          rep[0] = base + (n << 4) + reverse(align, 4);
        }
      }
    }
    for (count += 2; count > 0; --count, ++done) out[done] = out[done - rep[0] - 1];
  }
  return out;
}
