// SPDX-License-Identifier: MIT
// The module as the page sees it, and a run of a scene: what is done in it is written down, so any of its steps can be seen again. No word here
// knows of a page: the tests run it under node.

const INPUT = {grab: 0, move: 1, release: 2, shoot: 3, steer: 4};
const COLORS = ['awake', 'asleep', 'immovable', 'kinematic', 'frozen', 'sensor', 'axis_x', 'axis_y', 'axis_z', 'centre', 'bounds', 'L', 'omega',
                'contact', 'impulse', 'friction', 'joint', 'joint_axis', 'island'];
const KINDS = [
  'Sweeps', 'Sweeps or a direct solve, island by island', 'Sweeps; joints with limits and motors, levels', 'Moser–Veselov: ingot’s own',
  'Moser–Veselov, order 4', 'Runge–Kutta 4', 'Midpoint on the group', 'Euler, as the article printed it', 'Less effort: 2 substeps, 3 sweeps each',
  'More effort: 8 substeps, 6 sweeps each'
];
/// Of a step: in the order of viewer_past.
const PARTS = ['finding pairs', 'finding contacts', 'solving', 'all else'];
/// Of one body that only turns.
const turns = kind => kind >= 3 && kind <= 7;
const SHAPE_FLOATS = 20, LINE_FLOATS = 7, POINT_FLOATS = 4, TRIANGLE_FLOATS = 10;

class Engine {
  /// bytes: the module.
  static async load(bytes) {
    const parts = [0, 0, 0, 0], past = part => { const now = performance.now(); parts[part] += now - parts.at; parts.at = now; };
    const {instance} = await WebAssembly.instantiate(bytes, {ingot: {past}});
    return Object.assign(new Engine(instance.exports), {parts});
  }
  constructor(calls) {
    this.calls = calls;
    const word = pointer => {
      const bytes = new Uint8Array(calls.memory.buffer, pointer, 400);
      return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
    };
    this.scenes = Array.from({length: calls.scene_count()}, (_, i) => ({
      id: word(calls.scene_text(i, 0)), group: word(calls.scene_text(i, 1)), title: word(calls.scene_text(i, 2)), text: word(calls.scene_text(i, 3)),
      camera: Array.from(this.floats(calls.camera(i), 6)), wall: calls.wall(i), kind: calls.kind_of(i),
      kinds: KINDS.map((_, kind) => kind).filter(kind => calls.kinds_of(i) >> kind & 1)}));
    this.moments = Array.from(this.floats(calls.moments(), 3));
  }
  floats(pointer, count) { return new Float32Array(this.calls.memory.buffer, pointer, count); }
  answer(count) { return this.floats(this.calls.answer(), count); }

  hash(stage) { return BigInt.asUintN(64, this.calls.hash(stage)); }
  energy(stage) { return this.calls.energy(stage); }
  pick(stage, from, way) {
    const body = this.calls.pick(stage, ...from, ...way);
    if (body < 0) return null;
    const a = this.answer(7);
    return {body, P: [a[0], a[1], a[2]], movable: a[6] === 1};
  }
  body(stage, number) {
    if (!this.calls.body(stage, number)) return null;
    const a = Array.from(this.answer(23));
    return {r: a.slice(0, 3), A: a.slice(3, 12), L: a.slice(12, 15), omega: a.slice(15, 18), v: a.slice(18, 21), mass: a[21], energy: a[22]};
  }
  report(stage) {
    this.calls.report(stage);
    const a = this.answer(22);
    return {contacts: a[0], sweeps: a[1], residual: a[2], unfinished: a[3], lost: a[4], deferred: a[5], clamped: a[6], frozen: a[7], direct: a[8],
            clean: a[9] === 1, joints_lost: a[10], bodies: a[16], awake: a[17], asleep: a[18], islands: a[19], islands_asleep: a[20], joints: a[21]};
  }
  /// What the kernel's draw() makes of a stage; arrays are those of the module, until the next call. colors: names of COLORS.
  draw(stage, colors, scale) {
    const bits = colors.reduce((sum, name) => sum | 1 << COLORS.indexOf(name), 0);
    const counts = new Int32Array(this.calls.memory.buffer, this.calls.draw(stage, bits, scale), 3);
    return {shape_count: counts[0], shapes: this.floats(this.calls.shapes(), counts[0] * SHAPE_FLOATS),
            line_count: counts[1], lines: this.floats(this.calls.lines(), counts[1] * LINE_FLOATS),
            point_count: counts[2], points: this.floats(this.calls.points(), counts[2] * POINT_FLOATS)};
  }
  /// Triangles of the levels of a stage, TRIANGLE_FLOATS each.
  level(stage) { const count = this.calls.level(stage); return this.floats(this.calls.triangles(), count * TRIANGLE_FLOATS); }

  /// A stage as it is now: those of its pages that are not zero. A world of a few bodies in a type for hundreds is nearly all zero.
  save(stage) {
    const size = this.calls.size(stage), words = new Int32Array(this.calls.memory.buffer, this.calls.bytes(stage), size >> 2), pages = [];
    for (let at = 0; at < words.length; at += 1024) {
      const end = Math.min(at + 1024, words.length);
      let i = at;
      while (i < end && words[i] === 0) ++i;
      if (i < end) pages.push(at, words.slice(at, end));
    }
    return {size, pages, bytes: pages.length / 2 * 4096};
  }
  load(stage, saved) {
    const words = new Int32Array(this.calls.memory.buffer, this.calls.bytes(stage), saved.size >> 2);
    words.fill(0);
    for (let i = 0; i < saved.pages.length; i += 2) words.set(saved.pages[i + 1], saved.pages[i]);
  }
}

class Run {
  static every = 60;               // steps between two snapshots
  static room = 96 << 20;          // bytes of snapshots; above it every second one goes

  constructor(engine, stage) {
    this.engine = engine;
    this.stage = stage;
  }
  /// rate: steps a second.
  open(scene, kind, rate) {
    Object.assign(this, {
      scene,
      kind,
      rate,
      h: 1 / rate,
      at: 0,
      end: 0,
      inputs: [],
      applied: 0,
      hashes: [],
      times: [],
      parts: [0, 0, 0, 0],
      differs: false,
      spacing: Run.every,
      held: false
    });
    this.good = this.engine.calls.open(this.stage, scene, kind) === 1;
    this.snapshots = [];
    this.hashes[0] = this.engine.hash(this.stage);
    this.energy_0 = this.engine.energy(this.stage);
    this.keep();
    return this.good;
  }
  restart() { return this.open(this.scene, this.kind, this.rate); }

  get time() { return this.at * this.h; }
  get replays() { return this.at < this.end; }

  /// One step: with what was done then, where there is a record of it.
  step() {
    while (this.applied < this.inputs.length && this.inputs[this.applied].at === this.at) this.apply(this.inputs[this.applied++]);
    const {parts} = this.engine, begin = performance.now();
    parts.fill(0).at = begin;
    const status = this.engine.calls.step(this.stage, this.h);
    this.times[this.at % 240] = performance.now() - begin;
    parts.forEach((ms, i) => { this.parts[i] += (ms - this.parts[i]) / Math.min(60, this.at + 1); });
    const hash = this.engine.hash(this.stage);
    ++this.at;
    if (this.at <= this.end) this.differs ||= this.hashes[this.at] !== hash;
    else {
      this.hashes[this.at] = hash;
      this.end = this.at;
      if (this.at % this.spacing === 0) this.keep();
    }
    return status;
  }
  /// Something is done now. What was recorded beyond is given up.
  input(what, ...numbers) {
    this.cut();
    const input = {at: this.at, what: INPUT[what], numbers};
    this.inputs.push(input);
    ++this.applied;
    this.apply(input);
  }
  apply({what, numbers}) {
    if (what === INPUT.grab) this.held = true;
    if (what === INPUT.release) this.held = false;
    this.engine.calls.input(this.stage, what, ...numbers, ...new Array(6 - numbers.length).fill(0));
  }
  cut() {
    this.inputs.length = this.applied;
    this.hashes.length = this.at + 1;
    this.end = this.at;
    while (this.snapshots.length > 1 && this.snapshots[this.snapshots.length - 1].at > this.at) this.snapshots.pop();
  }

  seek(step) {
    step = Math.max(0, Math.min(step, this.end));
    let from = this.snapshots[0];
    for (const one of this.snapshots) if (one.at <= step) from = one;
    if (!(this.at <= step && this.at >= from.at)) {
      this.engine.load(this.stage, from.saved);
      this.at = from.at;
      this.applied = from.applied;
    }
    while (this.at < step) this.step();
  }
  keep() {
    this.snapshots.push({at: this.at, applied: this.applied, saved: this.engine.save(this.stage)});
    const bytes = this.snapshots.reduce((sum, one) => sum + one.saved.bytes, 0);
    if (bytes <= Run.room || this.snapshots.length < 4) return;
    this.spacing *= 2;
    this.snapshots = this.snapshots.filter(one => one.at % this.spacing === 0);
  }

  get hash() { return this.hashes[this.at]; }
  get untouched() { return this.applied === 0; }
  /// ms: the middle and the worst of the last 240 steps.
  timing() {
    const times = this.times.filter(time => time !== undefined).sort((a, b) => a - b);
    return times.length ? {median: times[times.length >> 1], worst: times[times.length - 1]} : null;
  }
}

/// The table of native_hashes.cpp: how far a run agrees with what the host computed.
class NativeTable {
  constructor(text) {
    this.rows = {};
    for (const line of text.trim().split('\n')) {
      const [id, h60, h120, h600, digits] = line.split(' ');
      this.rows[id] = {whole: {60: BigInt('0x' + h60), 120: BigInt('0x' + h120), 600: BigInt('0x' + h600)}, digits};
    }
  }
  /// null: nothing to compare with. Else {same, checked}: the steps up to here whose last digit, or whole hash, was looked at.
  compare(id, run, kind) {
    const row = this.rows[id];
    if (!row || kind !== run.kind || run.rate !== 60 || !run.untouched) return null;
    let same = true, checked = 0;
    for (let step = 1; step <= run.at && step <= 600; ++step) {
      const hash = run.hashes[step];
      if (hash === undefined) continue;
      same &&= Number(hash & 15n) === parseInt(row.digits[step - 1], 16) && (row.whole[step] === undefined || row.whole[step] === hash);
      checked = step;
    }
    return {same, checked, whole: [60, 120, 600].filter(step => step <= run.at)};
  }
}
