// SPDX-License-Identifier: MIT
// The page: what is clicked, what is drawn, what is told.

const $ = id => document.getElementById(id);
const clamp = (x, low, high) => Math.min(high, Math.max(low, x));

// What may be shown: the words, the colours of the kernel's drawing, and whether it is on to begin with.
const SHOW = [
  ['Axes', ['axis_x', 'axis_y', 'axis_z']], ['Centre of mass', ['centre']], ['Bounds', ['bounds']], ['Contacts', ['contact']],
  ['Impulses', ['impulse', 'friction']], ['Joints', ['joint', 'joint_axis']], ['L', ['L']], ['ω', ['omega']], ['Islands', []], ['Sleep', []],
  ['Trails', []]
];
const LINE_COLORS = {axis_x: '#d64545', axis_y: '#3a9d4b', axis_z: '#3f6fd8', centre: '#8a8f98', bounds: '#c9a63c', L: '#b04bc4', omega: '#1a9bb5',
                     contact: '#e2553f', impulse: '#ee8b2d', friction: '#7fa82e', joint: '#8a8f98', joint_axis: '#9a5fe0', island: '#c48ac4'};
const rgb = text => [1, 3, 5].map(i => parseInt(text.substr(i, 2), 16) / 255);
const THEMES = {
  light: {
    far: rgb('#e9ecee'),
    ground: rgb('#dfe2e4'),
    net: rgb('#c9ced2'),
    contrast: 1,
    body: rgb('#6f9fc8'),
    other: rgb('#d59a5b'),
    asleep: rgb('#a9b4bd'),
    fixed: rgb('#b9bcc0'),
    bad: rgb('#c04a3a'),
    held: rgb('#e0b040')
  },
  dark: {
    far: rgb('#14171a'),
    ground: rgb('#22262a'),
    net: rgb('#343a40'),
    contrast: 1,
    body: rgb('#5f93c2'),
    other: rgb('#c98d50'),
    asleep: rgb('#66717b'),
    fixed: rgb('#6d7379'),
    bad: rgb('#d06050'),
    held: rgb('#e8bc50')
  },
};

class Page {
  constructor(engine, native) {
    Object.assign(this, {
      engine,
      native,
      shown: new Set(['Sleep']),
      pace: 1,
      playing: true,
      due: 0,
      trails: new Map(),
      curve: [],
      camera: {at: [0, 0, 0], distance: 5, yaw: 0, pitch: 0}
    });
    this.runs = [new Run(engine, 0)];
    this.canvas = $('view');
    this.renderer = new Renderer(this.canvas);
    if (!this.renderer.gl) return void ($('text').textContent = 'This browser has no WebGL 2, so there is nothing to see.');
    this.dark = matchMedia('(prefers-color-scheme: dark)');
    this.fill_lists();
    this.listen();
    this.open_link() || this.open(0);
    requestAnimationFrame(now => this.frame(now));
  }
  get run() { return this.runs[0]; }
  get scene() { return this.engine.scenes[this.run.scene]; }
  get exact() { return this.scene.id === 'flip' || this.scene.id === 'bounce'; }

  fill_lists() {
    const groups = new Map();
    this.engine.scenes.forEach((scene, i) => {
      if (!groups.has(scene.group)) {
        const title = document.createElement('h2'), group = document.createElement('div');
        title.textContent = scene.group;
        group.className = 'group';
        $('scenes').append(title, group);
        groups.set(scene.group, group);
      }
      const button = document.createElement('button');
      button.textContent = scene.title;
      button.dataset.scene = scene.id;
      button.onclick = () => this.open(i);
      groups.get(scene.group).append(button);
    });
    for (const [name, colors] of SHOW) {
      const label = document.createElement('label'), box = document.createElement('input');
      box.type = 'checkbox';
      box.dataset.show = name;
      box.checked = this.shown.has(name);
      box.onchange = () => { box.checked ? this.shown.add(name) : this.shown.delete(name); if (name === 'Trails') this.trails.clear(); };
      label.append(box, name);
      if (colors.length) { const dot = document.createElement('i'); dot.style.background = LINE_COLORS[colors[0]]; label.append(dot); }
      $('toggles').append(label);
    }
  }

  // Scenes.

  open(scene, kind = this.engine.scenes[scene].kind, rate = 60) {
    this.run.open(scene, kind, rate);
    if ($('both').checked) $('both').checked = false;
    this.runs.length = 1;
    const [x, y, z, distance, yaw, pitch] = this.scene.camera;
    this.camera = {at: [x, y, z], distance, yaw, pitch};
    this.followed = ['car', 'biped'].includes(this.scene.id) ? 1 : null;
    this.begin();
    this.renderer.set_level(this.engine.level(0));
    const spins = ['flip', 'spin'].includes(this.scene.id);
    for (const name of ['L', 'ω']) spins ? this.shown.add(name) : this.shown.delete(name);
    this.scene.id === 'flip' ? this.shown.add('Axes') : this.shown.delete('Axes');
    ['pendulums', 'gears'].includes(this.scene.id) ? this.shown.add('Joints') : this.shown.delete('Joints');
    this.scene.id === 'heavy' ? this.shown.delete('Sleep') : this.shown.add('Sleep');
    for (const box of document.querySelectorAll('[data-show]')) box.checked = this.shown.has(box.dataset.show);
    $('title').textContent = this.scene.title;
    $('text').textContent = this.scene.text;
    for (const button of document.querySelectorAll('[data-scene]')) button.setAttribute('aria-current', button.dataset.scene === this.scene.id);
    for (const select of [$('kind'), $('kind_2')]) select.replaceChildren(...this.scene.kinds.map(kind => new Option(KINDS[kind], kind)));
    $('kind').disabled = $('kind_2').disabled = this.scene.kinds.length === 1;
    this.play(true);
    this.show_settings();
  }
  /// After a world was opened anew: whatever the page knew of it is gone.
  begin() {
    this.held = null;
    this.due = 0;
    this.trails.clear();
    this.curve = [];
    this.free = null;
    if (this.scene.id === 'flip') {
      const body = this.engine.body(0, 0);
      this.free = new FreeBody(this.engine.moments, body.A, body.L);
    }
  }
  /// The same scene with other settings, from its beginning; both worlds.
  open_again(change) {
    const [first, second] = this.runs, of = run => ({kind: run.kind, rate: run.rate});
    const settings = [of(first), second ? of(second) : null];
    change(settings);
    first.open(first.scene, settings[0].kind, settings[0].rate);
    this.runs.length = 1;
    if (settings[1]) {
      this.runs.push(new Run(this.engine, 1));
      this.runs[1].open(first.scene, settings[1].kind, settings[1].rate);
    }
    this.begin();
    this.show_settings();
  }
  show_settings() {
    this.runs.forEach((run, i) => {
      const tail = i ? '_2' : '';
      $('rate' + tail).value = Math.round(1000 * Math.log(run.rate / 30) / Math.log(1000 / 30));
      $('rate_text' + tail).textContent = `${run.rate} steps a second`;
      $('kind' + tail).value = run.kind;
    });
    $('other').hidden = $('halves').hidden = this.runs.length === 1;
    $('text').hidden = $('both').checked = this.runs.length > 1;
    this.runs.forEach((run, i) => { $('halves').children[i].textContent = `${run.rate} steps a second · ${KINDS[run.kind]}`; });
    $('error').hidden = !this.exact && this.runs.length === 1;
    const target = this.run.kind === 2, spring = !target && !turns(this.run.kind);
    $('mouse').textContent = target ? 'The mouse is a joint of the kernel, a target, that pulls at 8 Hz.'
      : spring ? 'In this world the mouse is a spring, critically damped, at 4 Hz: it knows no targets.' : '';
  }
  rate_of(value) {
    const rate = 30 * (1000 / 30) ** (value / 1000);
    return [30, 60, 120, 240, 480, 1000].find(round => Math.abs(Math.log(rate / round)) < 0.03) || Math.round(rate);
  }

  // Doing.

  play(on) {
    this.playing = on;
    this.due = 0;
    $('pause').textContent = on ? 'Pause' : 'Play';
  }
  input(what, ...numbers) { for (const run of this.runs) run.input(what, ...numbers); }
  restart() {
    for (const run of this.runs) run.restart();
    this.begin();
    this.play(true);
  }
  one() {
    this.play(false);
    this.advance(this.run.time + this.run.h);
  }
  replay() {
    if (this.held) this.release();
    for (const run of this.runs) run.seek(0);
    this.trails.clear();
    this.curve = [];
    this.play(true);
  }
  seek(step) {
    this.play(false);
    if (this.held) this.held = null;
    this.run.seek(step);
    for (const run of this.runs.slice(1)) run.seek(Math.round(this.run.time * run.rate));
    this.trails.clear();
    this.curve = this.curve.filter(point => point.t <= this.run.time);
  }
  /// All worlds up to a time, s.
  advance(time) {
    const begin = performance.now();
    for (const run of this.runs) {
      let steps = 0;
      while (run.at + 0.5 < time * run.rate && performance.now() - begin < 60 * this.runs.length) { run.step(); if (++steps > 4000) break; }
    }
    this.note_error();
  }
  shoot() {
    const {from, way} = this.renderer.ray(this.renderer.frame(this.camera, 0, this.runs.length), 0, 0), d = unit(way);
    const begin = plus(from, d, Math.min(2, this.camera.distance * 0.2));
    if (begin[2] < 0.35 && this.scene.id !== 'spin') begin[2] = 0.35;
    this.input('shoot', ...begin, ...d.map(x => x * clamp(2 * this.camera.distance, 12, 40)));
  }
  follow() {
    if (this.followed !== null) this.followed = null;
    else {
      const under = this.pointer ? this.pick(this.pointer) : null;
      this.followed = under && under.movable ? under.body : this.first_movable();
    }
    $('follow').setAttribute('aria-pressed', this.followed !== null);
  }
  first_movable() {
    const {shapes, shape_count} = this.engine.draw(0, [], 1);
    for (let i = 0; i < shape_count; ++i) if (COLORS[shapes[SHAPE_FLOATS * i + 17]] !== 'immovable') return shapes[SHAPE_FLOATS * i + 18];
    return 0;
  }

  // The pointer.

  /// A place on the canvas, CSS px: in which world, and the ray there.
  ray_at({x, y}) {
    const box = this.canvas.getBoundingClientRect(), ratio = this.canvas.width / box.width, px = (x - box.left) * ratio,
          py = this.canvas.height - (y - box.top) * ratio;
    for (let i = 0; i < this.runs.length; ++i) {
      const [left, low, w, h] = this.renderer.part(i, this.runs.length);
      if (px < left || py < low || px > left + w || py > low + h) continue;
      return {i, ...this.renderer.ray(this.renderer.frame(this.camera, i, this.runs.length), 2 * (px - left) / w - 1, 2 * (py - low) / h - 1)};
    }
    return null;
  }
  pick(place) {
    const ray = this.ray_at(place);
    return ray && this.engine.pick(ray.i, ray.from, unit(ray.way).map(x => x * 500));
  }
  down(event) {
    const place = {x: event.clientX, y: event.clientY}, hit = event.button === 0 && this.fingers.size === 0 ? this.pick(place) : null;
    this.canvas.setPointerCapture(event.pointerId);
    this.fingers.set(event.pointerId, place);
    if (this.fingers.size > 1) this.release();
    if (hit && hit.movable) {
      this.held = {id: event.pointerId, body: hit.body, P: hit.P};
      this.input('grab', ...hit.P, hit.body);
      if (!this.playing) this.play(true);
    }
  }
  move(event) {
    this.pointer = {x: event.clientX, y: event.clientY};
    const before = this.fingers.get(event.pointerId);
    if (!before) return;
    const now = this.pointer, dx = now.x - before.x, dy = now.y - before.y;
    if (this.held && this.held.id === event.pointerId) {
      const ray = this.ray_at(now);
      if (ray) {  // in the plane through the point that faces the camera
        const n = unit(minus(this.camera.at, ray.from)), t = dot(minus(this.held.P, ray.from), n) / dot(ray.way, n), P = plus(ray.from, ray.way, t);
        P[2] = Math.max(P[2], 0.05);
        this.held.P = P;
        this.input('move', ...P);
      }
    } else if (this.fingers.size === 2) {
      const other = [...this.fingers].find(([id]) => id !== event.pointerId)[1];
      this.zoom(Math.hypot(before.x - other.x, before.y - other.y) / Math.hypot(now.x - other.x, now.y - other.y));
      this.pan(dx / 2, dy / 2);
    } else if (event.buttons & 2 || event.shiftKey) this.pan(dx, dy);
    else {
      this.camera.yaw -= dx * 0.006;
      this.camera.pitch = clamp(this.camera.pitch + dy * 0.006, -0.2, 1.5);
    }
    this.fingers.set(event.pointerId, now);
  }
  up(event) {
    this.fingers.delete(event.pointerId);
    if (this.held && this.held.id === event.pointerId) this.release();
  }
  release() {
    if (!this.held) return;
    this.held = null;
    this.input('release');
  }
  zoom(by) { this.camera.distance = clamp(this.camera.distance * clamp(by, 0.5, 2), 0.8, 150); }
  pan(dx, dy) {
    const {look, tall} = this.renderer.frame(this.camera, 0, this.runs.length), s = 2 * tall * this.camera.distance / this.canvas.clientHeight;
    this.camera.at = plus(plus(this.camera.at, [look[0], look[4], look[8]], -dx * s), [look[1], look[5], look[9]], dy * s);
    this.followed = null;
  }

  listen() {
    const on = (id, what, does) => $(id).addEventListener(what, does);
    this.fingers = new Map();
    on('view', 'pointerdown', event => this.down(event));
    on('view', 'pointermove', event => this.move(event));
    for (const what of ['pointerup', 'pointercancel']) on('view', what, event => this.up(event));
    on('view', 'wheel', event => { event.preventDefault(); this.zoom(Math.exp(event.deltaY * 0.0012)); });
    on('view', 'contextmenu', event => event.preventDefault());
    on('pause', 'click', () => this.play(!this.playing));
    on('one', 'click', () => this.one());
    on('restart', 'click', () => this.restart());
    on('replay', 'click', () => this.replay());
    on('shoot', 'click', () => this.shoot());
    on('follow', 'click', () => this.follow());
    on('scrub', 'input', () => this.seek(+$('scrub').value));
    on('pace', 'change', () => { this.pace = +$('pace').value; });
    on('both', 'change', () => this.open_again(settings => {
      settings[1] = $('both').checked ? {kind: settings[0].kind, rate: settings[0].rate === 60 ? 240 : 60} : null;
    }));
    ['', '_2'].forEach((tail, i) => {
      on('rate' + tail, 'input', () => this.open_again(settings => { settings[i].rate = this.rate_of(+$('rate' + tail).value); }));
      on('kind' + tail, 'change', () => this.open_again(settings => { settings[i].kind = +$('kind' + tail).value; }));
    });
    on('link', 'click', event => { event.preventDefault(); this.make_link(); });
    for (const button of document.querySelectorAll('#tabs button')) button.onclick = () => {
      document.body.dataset.tab = button.dataset.tab;
      this.mark_tab();
    };
    this.mark_tab();
    this.keys = new Set();
    addEventListener('keydown', event => this.key(event, true));
    addEventListener('keyup', event => this.key(event, false));
    addEventListener('hashchange', () => this.open_link());
  }
  mark_tab() {
    for (const button of document.querySelectorAll('#tabs button'))
      button.setAttribute('aria-pressed', button.dataset.tab === document.body.dataset.tab);
  }
  key(event, down) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.target.matches('select') || (event.target.matches('input[type=range]') && event.key.startsWith('Arrow'))) return;
    const does = {
      p: () => this.play(!this.playing),
      o: () => this.one(),
      r: () => this.restart(),
      y: () => this.replay(),
      f: () => this.follow(),
      ' ': () => this.shoot()
    }[event.key.toLowerCase()];
    if (does && down && !(event.key === ' ' && event.repeat)) {
      event.preventDefault();
      does();
    }
    if (does && event.key === ' ') event.preventDefault();  // no click on the button that has the focus
    if (!event.key.startsWith('Arrow') || !['car', 'gears', 'stroll'].includes(this.scene.id)) return;
    event.preventDefault();
    down ? this.keys.add(event.key) : this.keys.delete(event.key);
    const has = name => this.keys.has('Arrow' + name) ? 1 : 0;
    let wheel = [has('Up') - has('Down'), has('Left') - has('Right')];
    if (this.scene.id === 'stroll') {  // as one sees it
      const s = Math.sin(this.camera.yaw), c = Math.cos(this.camera.yaw), [ahead, left] = wheel;
      wheel = [-s * ahead - c * left, c * ahead - s * left];
    }
    if (String(wheel) !== String(this.wheel)) this.input('steer', ...(this.wheel = wheel));
  }

  // Links.

  make_link() {
    const words = {scene: this.scene.id, step: this.run.at};
    if (this.run.rate !== 60) words.rate = this.run.rate;
    if (this.run.kind !== this.scene.kind) words.method = this.run.kind;
    history.replaceState(null, '', '#' + Object.entries(words).map(pair => pair.join('=')).join('&'));
    $('link').href = location.hash;
    if (navigator.clipboard) navigator.clipboard.writeText(location.href).catch(() => {});
    $('link').textContent = 'Link is in the address line';
    setTimeout(() => { $('link').textContent = 'Link to this scene and step'; }, 2000);
  }
  /// Goes where the address says; what it does not know it leaves out.
  open_link() {
    const words = new URLSearchParams(location.hash.slice(1)), scene = this.engine.scenes.findIndex(one => one.id === words.get('scene'));
    if (scene < 0) return false;
    const kind = Number(words.get('method') || NaN), rate = clamp(Math.round(Number(words.get('rate')) || 60), 30, 1000);
    this.open(scene, this.engine.scenes[scene].kinds.includes(kind) ? kind : undefined, rate);
    const step = clamp(Math.floor(Number(words.get('step')) || 0), 0, 20000);
    for (let i = 0; i < step; ++i) this.run.step();
    if (words.has('step')) this.play(false);
    this.note_error();
    return true;
  }

  // Error.

  note_error() {
    if (!this.exact && this.runs.length === 1) return;
    const last = this.curve[this.curve.length - 1], t = this.run.time;
    if (last && last.t >= t) return;
    let errors;
    if (this.free) errors = this.runs.map(run => angle_between(this.free.at(run.time), this.engine.body(run.stage, 0).A));
    else if (this.scene.id === 'bounce') errors = this.runs.map(run => Math.abs(this.engine.body(run.stage, 1).r[2] - 0.5 - bounce_height(run.time)));
    else errors = [this.difference()];
    this.curve.push({t, errors});
    if (this.curve.length > 2400) this.curve = this.curve.filter((_, i) => i % 2 === 0);
  }
  /// m: how far bodies are from themselves in the other world, on average.
  difference() {
    const places = this.runs.map(run => {
      const {shapes, shape_count} = this.engine.draw(run.stage, [], 1);
      return Array.from(shapes.subarray(0, shape_count * SHAPE_FLOATS));
    });
    let sum = 0, count = 0;
    for (let at = 0; at < Math.min(places[0].length, places[1].length); at += SHAPE_FLOATS) {
      if (COLORS[places[0][at + 17]] === 'immovable') continue;
      sum += Math.hypot(places[0][at + 4] - places[1][at + 4], places[0][at + 5] - places[1][at + 5], places[0][at + 6] - places[1][at + 6]);
      ++count;
    }
    return count ? sum / count : 0;
  }
  draw_chart() {
    if ($('error').hidden) return;
    const canvas = $('chart'), ratio = devicePixelRatio, w = canvas.clientWidth, h = canvas.clientHeight;
    if (!w) return;
    if (canvas.width !== Math.round(w * ratio)) { canvas.width = Math.round(w * ratio); canvas.height = Math.round(h * ratio); }
    const to = canvas.getContext('2d'), style = getComputedStyle(document.body), left = 46, low = h - 18, top = 8;
    to.setTransform(ratio, 0, 0, ratio, 0, 0);
    to.clearRect(0, 0, w, h);
    to.font = '11px ' + style.fontFamily;
    const soft = getComputedStyle($('error_text')).color, t_end = Math.max(2, this.run.time);
    const values = this.curve.flatMap(point => point.errors).filter(e => e > 0), floor = this.free ? 1e-7 : 1e-6;
    const high = Math.ceil(Math.log10(Math.max(floor * 100, ...values.slice(-4000)))),
          deep = Math.max(Math.log10(floor), Math.min(high - 2, Math.floor(Math.log10(Math.max(floor, Math.min(...values, 1))))));
    const x = t => left + (w - left - 4) * t / t_end,
          y = e => low - (low - top) * clamp((Math.log10(Math.max(e, 1e-30)) - deep) / (high - deep), 0, 1);
    to.textAlign = 'right';
    to.fillStyle = soft;
    to.strokeStyle = getComputedStyle(canvas.parentElement).color;
    const raised = n => [...String(n)].map(d => '⁰¹²³⁴⁵⁶⁷⁸⁹'['0123456789'.indexOf(d)] || '⁻').join('');
    const mark = n => this.free ? '10' + raised(n) : n >= 0 ? `${10 ** n} m` : n >= -3 ? `${10 ** (n + 3)} mm` : `${10 ** (n + 6)} µm`;
    for (let n = deep; n <= high; n += Math.ceil((high - deep) / 4)) {
      to.globalAlpha = 0.25;
      to.beginPath();
      to.moveTo(left, y(10 ** n));
      to.lineTo(w, y(10 ** n));
      to.stroke();
      to.globalAlpha = 1;
      to.fillText(mark(n), left - 5, y(10 ** n) + 4);
    }
    to.fillText(`${t_end.toFixed(0)} s`, w - 2, h - 4);
    to.textAlign = 'left';
    to.fillText('0', left, h - 4);
    this.runs.forEach((run, i) => {
      if (!this.curve.length || this.curve[0].errors[i] === undefined) return;
      to.strokeStyle = i ? '#d08a3e' : style.getPropertyValue('--mark');
      to.lineWidth = 1.5;
      to.beginPath();
      this.curve.forEach((point, n) => to[n ? 'lineTo' : 'moveTo'](x(point.t), y(point.errors[i])));
      to.stroke();
    });
    const last = this.curve[this.curve.length - 1],
          say = e => this.free ? (e > 0.02 ? `${(e * 57.29578).toFixed(1)}°` : `${e.toExponential(1)} rad`) :
        e >= 0.01 ? `${e.toFixed(3)} m` :
        e >= 1e-5 ? `${(e * 1e3).toFixed(2)} mm` :
                    `${(e * 1e6).toFixed(1)} µm`;
    const what = this.free         ? 'Turned away from the exact motion by' :
        this.scene.id === 'bounce' ? 'Away from the exact height by' :
                                     'Bodies of the two worlds are apart by, on average,';
    $('error_text').textContent = last ? `${what} ${last.errors.map(say).join(' and ')}.` : '';
  }

  // Frames.

  frame(now) {
    requestAnimationFrame(next => this.frame(next));
    const passed = Math.min(0.1, (now - (this.before || now)) / 1000);
    this.before = now;
    if (this.playing) {
      this.due = clamp(this.due + passed * this.pace, 0, 0.25);
      const begin = this.run.time, steps = Math.floor(this.due * this.run.rate + 1e-6);
      if (steps > 0) this.advance(begin + steps * this.run.h);
      this.due -= this.run.time - begin;
    }
    this.draw();
    if (!(this.told > now - 120)) {
      this.told = now;
      this.tell();
      this.draw_chart();
    }
  }
  draw() {
    const ratio = Math.min(devicePixelRatio, 2), w = Math.round(this.canvas.clientWidth * ratio), h = Math.round(this.canvas.clientHeight * ratio);
    if (this.canvas.width !== w || this.canvas.height !== h) Object.assign(this.canvas, {width: w, height: h});
    if (this.followed !== null) {
      const body = this.engine.body(0, this.followed);
      if (body) this.camera.at = plus(this.camera.at, minus(body.r, this.camera.at), 0.15);
    }
    const theme = {...THEMES[this.dark.matches ? 'dark' : 'light'], ratio};
    this.renderer.render(this.runs.map((run, i) => this.view_of(run, i, theme)), theme);
  }
  view_of(run, i, theme) {
    const colors = SHOW.filter(([name]) => this.shown.has(name)).flatMap(([, colors]) => colors);
    const drawn = this.engine.draw(run.stage, colors, clamp(this.camera.distance / 12, 0.4, 1.6)), {shapes} = drawn;
    const instances = {}, counts = {};
    let ground = null;
    for (let n = 0; n < drawn.shape_count; ++n) { const kind = shapes[SHAPE_FLOATS * n]; counts[kind] = (counts[kind] || 0) + 1; }
    for (const kind in counts)
      if (+kind !== KIND.half_space) instances[kind] = {array: this.renderer.take(`${i} ${kind}`, 20 * counts[kind]), floats: 0};
    for (let at = 0; at < drawn.shape_count * SHAPE_FLOATS; at += SHAPE_FLOATS) {
      const kind = shapes[at];
      if (kind === KIND.half_space) { if (shapes[at + 3] > 0.9) ground = shapes[at + 16]; continue; }
      const to = instances[kind], a = to.array, size = shapes.subarray(at + 1, at + 4), r = size[0];
      const of = kind === KIND.box ? [size[0], size[1], size[2], 0] :
          kind === KIND.sphere     ? [r, r, r, 0] :
          kind === KIND.capsule    ? [r, r, r, size[1]] :
          kind === KIND.level      ? [1, 1, 1, 0] :
                                     [r, r, size[1], 0];
      a.set(of, to.floats);
      a.set(shapes.subarray(at + 4, at + 16), to.floats + 4);
      a.set(this.paint(shapes[at + 17], shapes[at + 18], shapes[at + 19], theme), to.floats + 16);
      a[to.floats + 19] = kind === KIND.box ? 1 : kind === KIND.level ? 3 : 2;
      to.floats += 20;
    }
    const lines = this.lines_of(drawn, i), points = this.points_of(drawn, i);
    this.add_wall(lines);
    if (this.shown.has('Trails')) this.add_trails(run, i, drawn, lines);
    if (this.free) this.add_exact(run, lines);
    if (this.scene.id === 'bounce') this.add_ideal_ball(run, lines);
    return {camera: this.camera, instances, lines, points, ground};
  }
  paint(color, body, island, theme) {
    const name = COLORS[color];
    if (name === 'immovable') return theme.fixed;
    if (name === 'kinematic') return theme.other;
    if (name === 'frozen') return theme.bad;
    if (this.held && this.held.body === body) return theme.held;
    if (this.shown.has('Islands') && island >= 0) {
      const hue = island * 0.61803398875 % 1, k = n => {
        const x = (n + hue * 12) % 12;
        return 0.58 - 0.17 * Math.max(-1, Math.min(x - 3, 9 - x, 1));
      };
      return [k(0), k(8), k(4)];
    }
    if (name === 'asleep' && this.shown.has('Sleep')) return theme.asleep;
    const base = (this.scene.id === 'heavy' ? this.engine.body(0, body).mass >= 100 : body % 5 === 3) ? theme.other : theme.body,
          shade = 0.93 + 0.035 * (body * 7 % 5);
    return base.map(x => x * shade);
  }
  line_color(color) { return this.paints[color] ||= [...rgb(LINE_COLORS[COLORS[color]] || '#888888'), 1]; }
  paints = [];
  lines_of({lines, line_count}, i) {
    const to = {array: this.renderer.take(`${i} lines`, 10 * (line_count + 20000)), floats: 0};
    for (let at = 0; at < line_count * LINE_FLOATS; at += LINE_FLOATS) {
      to.array.set(lines.subarray(at, at + 6), to.floats);
      to.array.set(this.line_color(lines[at + 6]), to.floats + 6);
      to.floats += 10;
    }
    return to;
  }
  add_line(to, a, b, color) {
    if (to.floats + 10 > to.array.length) return;
    to.array.set(a, to.floats);
    to.array.set(b, to.floats + 3);
    to.array.set(color, to.floats + 6);
    to.floats += 10;
  }
  points_of({points, point_count}, i) {
    const to = {array: this.renderer.take(`${i} points`, 7 * (point_count + 1)), floats: 0};
    for (let at = 0; at < point_count * POINT_FLOATS; at += POINT_FLOATS) {
      to.array.set(points.subarray(at, at + 3), to.floats);
      to.array.set(this.line_color(points[at + 3]), to.floats + 3);
      to.floats += 7;
    }
    return to;
  }
  /// Walls of a pit are planes: where they meet the ground and each other.
  add_wall(lines) {
    const s = this.scene.wall, color = [0.5, 0.53, 0.56, 1];
    if (s === 0) return;
    const corner = [[-s, -s], [s, -s], [s, s], [-s, s]];
    corner.forEach((a, i) => {
      const b = corner[(i + 1) % 4];
      this.add_line(lines, [...a, 0], [...b, 0], color);
      this.add_line(lines, [...a, 0], [...a, s], color);
    });
  }
  add_trails(run, i, {shapes, shape_count}, lines) {
    for (let at = 0; at < shape_count * SHAPE_FLOATS; at += SHAPE_FLOATS) {
      if (COLORS[shapes[at + 17]] === 'immovable') continue;
      const key = i * 1e5 + shapes[at + 18], trail = this.trails.get(key) || [], r = Array.from(shapes.subarray(at + 4, at + 7)),
            end = trail[trail.length - 1];
      this.trails.set(key, trail);
      if (!end || Math.hypot(...minus(r, end)) > 0.02) trail.push(r);
      if (trail.length > 90) trail.shift();
      for (let n = 1; n < trail.length; ++n) this.add_line(lines, trail[n - 1], trail[n], [0.35, 0.6, 0.85, 1]);
    }
  }
  /// The exact motion, as the edges of a box.
  add_exact(run, lines) {
    const A = this.free.at(run.time), half = [0.5, 0.3, 0.1].map(x => x * 1.004),
          corner = n => [0, 1, 2].reduce((p, i) => plus(p, A.slice(3 * i, 3 * i + 3), (n >> i & 1 ? 1 : -1) * half[i]), [0, 0, 0]);
    for (let n = 0; n < 8; ++n)
      for (let i = 0; i < 3; ++i)
        if (!(n >> i & 1)) this.add_line(lines, corner(n), corner(n | 1 << i), [0.92, 0.45, 0.3, 1]);
  }
  add_ideal_ball(run, lines) {
    const z = 0.5 + bounce_height(run.time), at = (a, k) => {
      const c = 0.505 * Math.cos(a), s = 0.505 * Math.sin(a);
      return [[c, s, z], [c, 0, z + s], [0, c, z + s]][k];
    };
    for (let k = 0; k < 3; ++k)
      for (let n = 0; n < 40; ++n) this.add_line(lines, at(n * Math.PI / 20, k), at((n + 1) * Math.PI / 20, k), [0.92, 0.45, 0.3, 1]);
  }

  // Words.

  tell() {
    const {run} = this, report = this.engine.report(0), energy = this.engine.energy(0), timing = run.timing(), gain = energy - run.energy_0;
    const number = x => x.toLocaleString('en', {maximumFractionDigits: 0});
    const joule = x => Math.abs(x) >= 1e5 ? `${(x / 1000).toFixed(0)} kJ` :
        Math.abs(x) >= 1e3 ? `${(x / 1000).toFixed(2)} kJ` :
                             `${x.toFixed(Math.abs(x) < 10 ? 3 : 1)} J`;
    const speed = x => x >= 0.1 ? `${x.toFixed(2)} m/s` :
        x >= 1e-3 ? `${(x * 1e3).toFixed(1)} mm/s` :
        x > 0 ? `${(x * 1e6).toFixed(1)} µm/s` :
                'nothing';
    const facts = [['Bodies', number(report.bodies)]];
    if (!turns(run.kind)) {
      facts.push(['asleep', number(report.asleep)], ['Touching pairs', number(report.contacts)], ['Islands awake', number(report.islands)]);
      if (report.joints) facts.push(['Joints', number(report.joints)]);
      facts.push(['Sweeps', number(report.sweeps)], ['left to correct', speed(report.residual)]);
    }
    facts.push(['Energy', joule(energy)], [
      'since the start',
      turns(run.kind) ? `${gain >= 0 ? '+' : '−'}${(Math.abs(gain / run.energy_0) * 100).toPrecision(2)} %` :
                        `${
                            gain > 0     ? '+' :
                                gain < 0 ? '−' :
                                           ''}${joule(Math.abs(gain))}`
    ]);
    if (timing) facts.push(['A step takes', `${timing.median.toFixed(2)} ms`], ['at worst', `${timing.worst.toFixed(1)} ms`]);
    if (timing && !turns(run.kind)) PARTS.forEach((name, i) => facts.push([name, `${run.parts[i].toFixed(2)} ms`]));
    const text = facts.map(pair => pair.join('\t')).join('\n');
    if (text !== this.facts) {
      this.facts = text;
      $('facts').replaceChildren(...facts.flatMap(([name, value]) => {
        const dt = document.createElement('dt'), dd = document.createElement('dd');
        dt.textContent = name;
        dd.textContent = value;
        return [dt, dd];
      }));
    }
    $('words').textContent = this.words(report);
    $('scrub').max = run.end;
    if (document.activeElement !== $('scrub') || this.playing) $('scrub').value = run.at;
    $('clock').textContent = `step ${run.at} of ${run.end} · ${run.time.toFixed(2)} s`;
    $('pause').textContent = this.playing ? 'Pause' : 'Play';
    $('follow').setAttribute('aria-pressed', this.followed !== null);
    this.tell_bits();
  }
  words(report) {
    const said = [], many = (n, one, more) => `${n} ${n === 1 ? one : more}`;
    if (report.frozen) said.push(many(report.frozen, 'body was', 'bodies were') + ' driven out of range and stand still');
    if (report.lost) said.push(many(report.lost, 'contact', 'contacts') + ' had no room');
    if (report.deferred) said.push(many(report.deferred, 'impact waits', 'impacts wait') + ' for the next step');
    if (report.clamped) said.push('a turn was larger than a step allows');
    if (report.unfinished) said.push(many(report.unfinished, 'island has', 'islands have') + ' not settled yet');
    if (report.joints_lost) said.push(many(report.joints_lost, 'joint holds', 'joints hold') + ' nothing');
    if (report.direct & 1) said.push('an island was solved directly');
    if (report.direct & 2) said.push('a direct solve gave way to sweeps');
    if (report.bodies && !turns(this.run.kind) && report.awake === 0) said.push('everything sleeps');
    if (!said.length) return this.run.at ? 'The step did all it was asked for.' : '';
    const text = said.join('; ') + '.';
    return text[0].toUpperCase() + text.slice(1);
  }
  tell_bits() {
    const {run} = this, table = this.native.compare(this.scene.id, run, this.scene.kind),
          code = `<code>${run.hash.toString(16).padStart(16, '0')}</code>`;
    let mark = '';
    if (run.differs) mark = '<span class="bad">This replay differs from what was recorded.</span>';
    else if (table && !table.same) mark = '<span class="bad">Not the bits that the native build computed.</span>';
    else if (table && table.checked)
      mark = `<span class="good">✓ Same bits as native</span>, each step up to ${table.checked}${
          table.whole.length ? `; whole hash at ${table.whole.join(', ')}` : ''}.`;
    else if (run.replays) mark = '<span class="good">✓ Same bits as recorded</span> so far.';
    else if (!run.untouched) mark = 'You have changed it. Replay computes the same bits again.';
    else if (run.at) mark = 'The native table is of 60 steps a second and the method that the scene begins with.';
    const html = code + '<br>' + mark;
    if (html !== this.bits) $('bits').innerHTML = this.bits = html;
  }
}

/// bytes: of the module; table: of native_hashes.cpp.
async function begin(bytes, table) {
  try {
    globalThis.page = new Page(await Engine.load(bytes), new NativeTable(table));
  } catch (error) {
    $('text').textContent = `This browser cannot show it: ${error.message}`;
    throw error;
  }
}
