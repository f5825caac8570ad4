// SPDX-License-Identifier: MIT
// Exact motions, in double: what the error curves of the page are measured against.

/// sn, cn, dn of u for 1 - k^2 = m_1, by the arithmetic-geometric mean (Abramowitz and Stegun 16.4).
function jacobi(u, m_1) {
  const a = [1], c = [Math.sqrt(1 - m_1)];
  let b = Math.sqrt(m_1), n = 0;
  while (Math.abs(c[n]) > 1e-16 && n < 30) {
    a.push((a[n] + b) / 2);
    c.push((a[n] - b) / 2);
    b = Math.sqrt(a[n] * b);
    ++n;
  }
  let phi = 2 ** n * a[n] * u;
  for (; n > 0; --n) phi = (phi + Math.asin(c[n] / a[n] * Math.sin(phi))) / 2;
  const sn = Math.sin(phi), cn = Math.cos(phi);
  return {sn, cn, dn: Math.sqrt(m_1 + (1 - m_1) * cn * cn)};
}
/// The incomplete integral of the first kind, by the descending transformation of its angle (17.6).
function elliptic_f(phi, m_1) {
  let a = 1, b = Math.sqrt(m_1), scale = 1;
  for (let n = 0; n < 30 && Math.abs(a - b) > 1e-16 * a; ++n) {
    const t = b / a * Math.tan(phi);
    phi = phi + Math.atan(t) + Math.PI * Math.round((phi - Math.atan(t)) / Math.PI);
    [a, b] = [(a + b) / 2, Math.sqrt(a * b)];
    scale *= 2;
  }
  return phi / (scale * a);
}

const transpose_times = (A, v) => [0, 3, 6].map(c => A[c] * v[0] + A[c + 1] * v[1] + A[c + 2] * v[2]);
const times = (A, B) => {  // by columns
  const C = new Array(9).fill(0);
  for (let r = 0; r < 3; ++r) for (let c = 0; c < 3; ++c) for (let k = 0; k < 3; ++k) C[3 * c + r] += A[3 * k + r] * B[3 * c + k];
  return C;
};
const transposed = A => [A[0], A[3], A[6], A[1], A[4], A[7], A[2], A[5], A[8]];
/// rad, between two attitudes.
const angle_between = (A, B) => 2 * Math.asin(Math.min(1, Math.sqrt(A.reduce((sum, a, i) => sum + (a - B[i]) ** 2, 0)) / Math.sqrt(8)));

/// A free body with three different moments: its spin by Jacobi's functions (Landau and Lifshitz, Mechanics, 37), and the turn about L, whose rate is
/// a smooth function of them, by Gauss's rule to rounding.
class FreeBody {
  /// I: kg m^2, along x, y, z of the body; A: by columns; L: kg m^2/s, world.
  constructor(I, A, L) {
    const Lb = transpose_times(A, L), w = Lb.map((l, i) => l / I[i]);
    const above = J => Lb.reduce((sum, l, i) => sum + l * w[i] * (I[i] - J), 0);  // L^2 - 2 E J, and no digit lost
    const by_size = [0, 1, 2].sort((a, b) => I[a] - I[b]);
    // Axis 3 is the one that the spin keeps to one side of: that of the largest moment, or of the smallest.
    const [i1, i2, i3] = above(I[by_size[1]]) >= 0 ? by_size : by_size.slice().reverse();
    const [I1, I2, I3] = [I[i1], I[i2], I[i3]];
    Object.assign(this, {i: [i1, i2, i3], I, L: Math.hypot(...Lb)});
    this.a = [Math.sqrt(-above(I3) / (I1 * (I3 - I1))), Math.sqrt(-above(I3) / (I2 * (I3 - I2))), Math.sqrt(above(I1) / (I3 * (I3 - I1)))];
    this.rate = Math.sqrt((I3 - I2) * above(I1) / (I1 * I2 * I3));
    this.m_1 = (I3 - I1) * above(I2) / ((I3 - I2) * above(I1));
    // Axes 1, 2, 3 may be left-handed, and their moments fall: each turns the sense round.
    const side = w[i3] < 0 ? -1 : 1, even = (i2 - i1 + 3) % 3 === 1, rising = I1 < I3;
    this.sign = [1, side * (even === rising ? 1 : -1), side];
    this.u_0 = elliptic_f(Math.atan2(w[i2] / (this.sign[1] * this.a[1]), w[i1] / this.a[0]), this.m_1);
    this.psi = 0;
    this.t = 0;
    this.to_world = times(A, transposed(this.attitude(0, 0)));
  }
  spin(t) {
    const {sn, cn, dn} = jacobi(this.rate * t + this.u_0, this.m_1), w = [0, 0, 0];
    [cn, sn, dn].forEach((value, n) => { w[this.i[n]] = this.sign[n] * this.a[n] * value; });
    return w;
  }
  /// In a frame whose z is along L: Euler's angles, with axis 3 as the one that is inclined.
  attitude(t, psi) {
    const w = this.spin(t), k = this.i[2], [x, y, z] = [(k + 1) % 3, (k + 2) % 3, k], l = [x, y, z].map(i => this.I[i] * w[i] / this.L);
    const rho = Math.hypot(l[0], l[1]), [sp, cp] = [l[0] / rho, l[1] / rho], st = rho, ct = l[2], ss = Math.sin(psi), cs = Math.cos(psi),
          B = new Array(9);
    const columns = [
      [cs * cp - ss * ct * sp, ss * cp + cs * ct * sp, st * sp], [-cs * sp - ss * ct * cp, -ss * sp + cs * ct * cp, st * cp], [ss * st, -cs * st, ct]
    ];
    [x, y, z].forEach((i, n) => columns[n].forEach((value, r) => { B[3 * i + r] = value; }));
    return B;
  }
  psi_rate(t) {
    const w = this.spin(t), k = this.i[2], [x, y] = [(k + 1) % 3, (k + 2) % 3], I = this.I;
    return this.L * (I[x] * w[x] ** 2 + I[y] * w[y] ** 2) / ((I[x] * w[x]) ** 2 + (I[y] * w[y]) ** 2);
  }
  at(t) {
    if (t < this.t) this.t = this.psi = 0;
    const nodes = [0.1834346424956498, 0.525532409916329, 0.7966664774136267, 0.9602898564975363];
    const weights = [0.362683783378362, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763];
    while (this.t < t - 1e-12) {
      const h = Math.min(t - this.t, 0.02), middle = this.t + h / 2;
      nodes.forEach((node, i) => { this.psi += h / 2 * weights[i] * (this.psi_rate(middle - node * h / 2) + this.psi_rate(middle + node * h / 2)); });
      this.t += h;
    }
    return times(this.to_world, this.attitude(t, this.psi));
  }
}

/// m: how high an ideal ball is above the ground, whose bounces each keep e of the speed. It is let go from H at rest.
function bounce_height(t, H = 3, e = 0.8, g = 9.81) {
  let v = Math.sqrt(2 * g * H), begin = v / g;
  if (t < begin) return H - g * t * t / 2;
  for (let n = 0; n < 60; ++n) {
    v *= e;
    const flight = 2 * v / g;
    if (t < begin + flight) return v * (t - begin) - g * (t - begin) ** 2 / 2;
    begin += flight;
  }
  return 0;
}
