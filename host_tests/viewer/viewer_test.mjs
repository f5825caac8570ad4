// SPDX-License-Identifier: MIT
// node viewer_test.mjs viewer.html viewer.wasm native_hashes.txt [--speed]: what the page does, without a browser; or, on an idle machine, that a step of
// 512 balls takes no more than 4 ms of processor, on average over five seconds and the best of three, as the page steps them.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import vm from 'node:vm';

const [, , page_path, module_path, table_path] = process.argv;
const here = dirname(fileURLToPath(import.meta.url));
const read = name => readFileSync(join(here, name), 'utf8');
const {Engine, Run, NativeTable, FreeBody, angle_between, transpose_times, bounce_height, from_116, from_lzma, joined, KINDS, SHAPE_FLOATS} =
    vm.runInThisContext(`${read('unpack.js')}${read('streams.js')}${read('engine.js')}${read('exact.js')}
  ;({Engine, Run, NativeTable, FreeBody, angle_between, transpose_times, bounce_height, from_116, from_lzma, joined, KINDS, SHAPE_FLOATS})`);
const page = readFileSync(page_path, 'utf8'), bytes = readFileSync(module_path), table = readFileSync(table_path, 'utf8');
const engine = await Engine.load(bytes), native = new NativeTable(table);
const number = id => { const i = engine.scenes.findIndex(scene => scene.id === id); assert(i >= 0, id); return i; };
const open = (id, kind, rate = 60, stage = 0) => {
  const run = new Run(engine, stage), scene = engine.scenes[number(id)];
  assert(run.open(number(id), kind ?? scene.kind, rate), id);
  return run;
};
const go = (run, steps) => { for (let i = 0; i < steps; ++i) assert.equal(run.step(), 0); return run; };
const length = v => Math.hypot(...v);
const away = (a, b) => length(a.map((x, i) => x - b[i]));

const speed = {
  a_step_of_512_balls_takes_4_ms_at_most() {
    const runs = [1, 2, 3].map(() => {
      const run = open('balls'), begin = process.cpuUsage();
      go(run, 300);
      const {user, system} = process.cpuUsage(begin);
      return (user + system) / 1000 / 300;
    });
    console.log(`512 balls: ${runs.map(ms => ms.toFixed(2)).join(', ')} ms of processor a step`);
    assert(Math.min(...runs) <= 4);
  },
};
const tests = {
  the_page_holds_the_module_and_asks_for_nothing() {
    assert(page.length <= 250000, `${page.length} bytes`);
    const sizes = JSON.parse(page.match(/const sizes = (\[[\d, ]+\])/)[1]), sum = sizes.reduce((a, b) => a + b);
    const all = from_lzma(from_116(page.match(/from_116\('([^']*)'\)/)[1]), sum);
    let at = 0;
    const parts = sizes.map(size => all.subarray(at, at += size)), [table_in_it, style, body, script] = parts.slice(-4).map(part => Buffer.from(part).toString());
    assert(Buffer.from(joined(parts.slice(0, -4))).equals(bytes));
    assert.equal(table_in_it, table);
    new vm.Script(script);
    for (const text of [page.replace(/from_116\('[^']*'\)/, ''), style, body])
      assert(!/\b(src|href)=["'](?!#)|url\(|@import|https?:/.test(text), 'names something outside');
  },
  the_module_imports_a_watch_alone() {
    assert.deepEqual(WebAssembly.Module.imports(new WebAssembly.Module(bytes)), [{module: 'ingot', name: 'past', kind: 'function'}]);
  },
  stages_take_together_what_a_step_takes() {
    for (const kind of engine.scenes[number('boxes')].kinds) {
      const run = open('boxes', kind), whole = () => run.times.slice(0, 60).reduce((sum, ms) => sum + ms) / 60;
      go(run, 60);  // until then both are plain means
      const sum = run.parts.reduce((a, b) => a + b);
      assert(run.parts.every(ms => ms > 0) && sum <= whole() && sum > 0.9 * whole(), `${KINDS[kind]}: ${run.parts} of ${whole()} ms`);
    }
    const asleep = go(open('pyramid'), 300), {parts} = engine;
    assert(engine.report(0).awake === 0 && parts.every(ms => ms === 0), 'a step that nobody is awake for has no stages');
    const before = [...asleep.parts];
    go(asleep, 60);
    asleep.parts.forEach((ms, i) => assert(Math.abs(ms / before[i] / (59 / 60) ** 60 - 1) < 1e-12));
  },
  every_scene_opens_in_all_its_worlds_and_steps() {
    assert.equal(KINDS.length, engine.calls.kind_count());
    for (const scene of engine.scenes) for (const kind of scene.kinds) {
      const run = go(open(scene.id, kind), 3), {bodies} = engine.report(0), {shape_count} = engine.draw(0, [], 1);
      assert(bodies > 0 && shape_count === bodies + (scene.id === 'stroll' ? 1 : 0), `${scene.id}, ${KINDS[kind]}`);  // the character is no body
      assert(scene.title && scene.text && scene.group);
      assert.equal(run.at, 3);
      }
    assert.equal(engine.calls.open(0, 0, engine.scenes[0].kind + 5), 0);  // a kind it has not
    assert.equal(engine.calls.open(0, 999, 0), 0);
  },
  every_scene_has_the_bits_of_the_native_build() {
    for (const scene of engine.scenes) {
      const run = go(open(scene.id), 600), of = native.compare(scene.id, run, scene.kind), row = native.rows[scene.id];
      for (const step of [60, 120, 600]) assert.equal(run.hashes[step], row.whole[step], `${scene.id} at ${step}`);
      assert(of.same && of.checked === 600, scene.id);
    }
  },
  a_wrong_bit_is_noticed() {
    const run = go(open('crate'), 60);
    run.hashes[37] ^= 1n;
    assert.equal(native.compare('crate', run, run.kind).same, false);
  },
  a_ray_picks_what_it_meets_first() {
    open('crate');
    const hit = engine.pick(0, [0, 0, 10], [0, 0, -20]), ground = engine.pick(0, [5, 5, 10], [0, 0, -20]);
    assert.equal(hit.body, 1);
    assert(hit.movable && hit.P[2] > 3.4 && hit.P[2] < 3.9);
    assert(ground.body === 0 && !ground.movable && Math.abs(ground.P[2]) < 1e-6);
    assert.equal(engine.pick(0, [0, 0, 10], [0, 0, 5]), null);
  },
  the_mouse_draws_a_body_to_where_it_is() {
    for (const [id, kind, body] of [['crate', 0, 1], ['crate', 1, 1], ['ragdolls', 2, 6], ['chain', 2, 13]]) {
      const run = go(open(id, kind), 30), P = engine.body(0, body).r, to = [P[0] + 0.3, P[1] + 0.6, P[2] + 0.8];
      run.input('grab', ...P, body);
      run.input('move', ...to);
      go(run, 240);
      const r = engine.body(0, body).r;
      // A chain gives what it has: the ball swings as far as it can.
      assert(away(r, to) < (id === 'chain' ? 0.8 * away(P, to) : 0.05), `${id}, ${KINDS[kind]}: ${away(r, to)} m away`);
      run.input('release');
      go(run, 120);
      if (id === 'crate') assert(engine.body(0, body).r[2] < to[2] - 0.2, 'it falls when it is let go');
    }
  },
  the_spring_of_the_mouse_rings_at_no_rate() {
    for (const rate of [30, 60, 1000]) {
      const run = open('crate', 1, rate), to = [0, 0, 4];
      run.input('grab', ...engine.body(0, 1).r, 1);
      run.input('move', ...to);
      go(run, 3 * rate);
      assert(away(engine.body(0, 1).r, to) < 0.01 && length(engine.body(0, 1).v) < 0.01, `${rate} steps a second`);
    }
  },
  what_was_done_is_replayed_to_the_same_bits() {
    for (const [id, kind] of [['pyramid', 0], ['pyramid', 1], ['car', 2]]) {
      const run = go(open(id, kind), 40);
      run.input('grab', ...engine.body(0, 3).r, 3);
      go(run, 10);
      run.input('move', 0, -3, 2);
      go(run, 55);
      run.input('release');
      run.input('shoot', 0, -12, 3, 0, 30, 1);
      if (id === 'car') run.input('steer', 1, 0.5);
      go(run, 150);
      const end = run.hash, middle = run.hashes[100];
      run.seek(0);
      assert(run.replays && run.hash === run.hashes[0]);
      go(run, 255);
      assert(run.hash === end && engine.hash(0) === end && !run.differs, id);
      run.seek(100);
      assert(engine.hash(0) === middle && run.end === 255);
      run.seek(255);
      assert(engine.hash(0) === end && !run.differs);
      run.seek(90);
      run.input('shoot', 0, -12, 3, 0, 30, 1);
      assert(run.end === 90 && !run.replays);
      go(run, 30);
      assert(run.at === 120 && run.end === 120);
    }
  },
  a_restart_is_the_first_run() {
    const run = go(open('dominoes'), 90), first = run.hashes.slice();
    run.input('shoot', 0, -6, 2, 0, 20, 0);
    go(run, 60);
    run.restart();
    assert(run.at === 0 && run.end === 0 && run.untouched);
    go(run, 90);
    assert.deepEqual(run.hashes, first);
  },
  two_stages_know_nothing_of_each_other() {
    const a = go(open('boxes', 0, 60, 0), 30), b = go(open('balls', 0, 60, 1), 30);
    go(a, 30);
    assert.equal(a.hash, native.rows.boxes.whole[60]);
    go(b, 30);
    assert.equal(b.hash, native.rows.balls.whole[60]);
  },
  snapshots_keep_within_their_room() {
    const room = Run.room;
    Run.room = 2 << 20;
    const run = go(open('boxes'), 700);
    assert(run.spacing > Run.every && run.snapshots[0].at === 0);
    assert(run.snapshots.reduce((sum, one) => sum + one.saved.bytes, 0) <= Run.room);
    Run.room = room;
    run.seek(333);
    assert.equal(engine.hash(0), run.hashes[333]);
  },
  many_balls_are_shot_and_the_oldest_goes() {
    const run = open('crate');
    for (let i = 0; i < 60; ++i) { run.input('shoot', 0, -8, 2, i % 7 - 3, 15, 5); go(run, 3);
    }
    assert.equal(engine.report(0).bodies, 2 + 24);
  },
  the_drawing_is_what_is_asked_for() {
    go(open('bridge'), 60);
    const none = engine.draw(0, [], 1);
    assert(none.line_count === 0 && none.point_count === 0);
    const joints = engine.draw(0, ['joint', 'joint_axis'], 1).line_count, contacts = engine.draw(0, ['contact'], 1).point_count;
    assert(joints >= 17 && contacts > 0);
    assert.equal(engine.draw(0, ['bounds'], 1).line_count, 12 * (engine.report(0).bodies - 1));  // of all but the ground
  },
  heavy_on_light_gives_nothing_by_the_direct_solve_and_a_little_by_sweeps() {
    const sunk = kind => { go(open('heavy', kind), 300); return 9.5 - engine.body(0, 12).r[2]; };
    assert(Math.abs(sunk(1)) < 1e-5);  // ten rows of a rounding of 9.5 m
    assert(sunk(0) > 1e-4 && sunk(0) < 2e-3);
  },
  nothing_gets_through_the_last_plate() {
    const run = open('bullets');
    for (let i = 0; i < 120; ++i) {
      go(run, 1);
      for (let body = 6; body < 10; ++body) assert(engine.body(0, body).r[0] < 5.05);
    }
  },
  a_character_goes_round_over_stairs_and_pushes_crates() {
    const run = open('stroll'), heights = [];
    assert.equal(engine.level(0).length, 10 * 74);  // of 108 some have no area
    for (let i = 0; i < 1200; ++i) { go(run, 1); const {r} = engine.body(0, -1); heights.push(r[2]); assert(Math.hypot(r[0], r[1]) < 4.6); }
    const low = 0.9 + 0.01, high = low + 8 * 0.15625;  // its half, its skin, the stairs
    assert(Math.abs(Math.min(...heights.slice(60)) - low) < 1e-3 && Math.abs(Math.max(...heights) - high) < 1e-3);
    run.input('steer', 0, 0);
    go(run, 60);
    const stood = engine.body(0, -1).r;
    go(run, 60);
    assert(away(engine.body(0, -1).r, stood) < 1e-3);
  },
  ice_lets_things_slide_and_grass_does_not() {
    const run = go(open('tumble'), 600), triangles = engine.level(0);
    assert(triangles.length === 10 * 2 * 24 * 24 && triangles.some((x, i) => i % 10 === 9 && x === 1));
    assert(engine.report(0).asleep > 0);
  },
  a_walker_walks_and_gears_keep_their_ratio() {
    go(open('biped'), 600);
    assert(engine.body(0, 1).r[0] > 3 && engine.body(0, 1).r[2] > 1.1, `${engine.body(0, 1).r}`);
    const run = open('gears');
    const height = () => engine.body(0, 3).r[2], low = height();
    go(run, 60);
    const [pinion, wheel] = [1, 2].map(body => engine.body(0, body).omega[1]);
    assert(Math.abs(pinion + 3 * wheel) < 1e-4 * pinion, `${pinion} ${wheel}`);
    go(run, 600);
    assert(Math.abs(height() - low - 2.2) < 1e-2, `${height() - low} m: up to its stop`);
  },
  pendulums_come_together_after_half_a_minute() {
    const run = go(open('pendulums'), 1800);
    for (let body = 1; body <= 13; ++body) {
      const {r} = engine.body(0, body), angle = Math.atan2(r[1], 2.4 - r[2]);
      assert(Math.abs(angle - 0.3) < 1.7e-3, `${body}: ${angle} rad`);  // a tenth of a degree: 0.107 rad of phase, of 75 to 151
    }
    assert(Math.abs(engine.energy(0) - run.energy_0) < 1e-5 * run.energy_0);
  },
  the_closed_form_of_a_free_body_is_its_equation() {
    const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    for (const [I, w] of [
             [[1, 2, 2.5], [0.3, -0.5, 2]], [[1, 2, 2.5], [-2, 0.5, -0.3]], [[2.5, 1, 2], [0.5, 0.7, -0.4]], [[2, 1, 2.5], [0.5, -0.7, 0.4]],
             [[2, 2.5, 1], [0.1, -0.7, 0.9]], [[2, 2.5, 1], [0.1, 2.7, -0.1]]]) {
      let A = [1, 0, 0, 0, 1, 0, 0, 0, 1];
      const L = w.map((x, i) => x * I[i]), body = new FreeBody(I, A, L), steps = 4000, h = 5 / steps;
      const rate = B => {
        const s = transpose_times(B, L).map((l, i) => l / I[i]), W = [0, 1, 2].map(r => B[r] * s[0] + B[3 + r] * s[1] + B[6 + r] * s[2]);
        return [0, 1, 2].flatMap(c => cross(W, B.slice(3 * c, 3 * c + 3)));
      };
      const add = (B, k, s) => B.map((b, i) => b + s * k[i]);
      for (let i = 0; i < steps; ++i) {
        const a = rate(A), b = rate(add(A, a, h / 2)), c = rate(add(A, b, h / 2)), d = rate(add(A, c, h));
        A = A.map((x, n) => x + h / 6 * (a[n] + 2 * b[n] + 2 * c[n] + d[n]));
      }
      assert(
          angle_between(A, body.at(5)) < 1e-9, `${I} ${w}: ${angle_between(A, body.at(5))}`);  // of order 4: (|omega| h)^4 over 5 s is 5e-10 at most
    }
  },
  methods_are_told_apart_by_the_exact_motion() {
    const error = (kind, rate, seconds) => {
      const run = open('flip', kind, rate), body = engine.body(0, 0), exact = new FreeBody(engine.moments, body.A, body.L);
      go(run, seconds * rate);
      return angle_between(exact.at(run.time), engine.body(0, 0).A);
    };
    const own = error(3, 60, 2), printed = error(7, 60, 2), midpoint = error(6, 120, 0.5), finer = error(6, 480, 0.5);
    assert(own < 1e-3 && printed > 100 * own, `${own} ${printed}`);
    assert(midpoint / finer > 8 && midpoint / finer < 32, `order 2: ${midpoint / finer}`);  // 16 to leading order
  },
  the_ball_bounces_as_an_ideal_one_does() {
    const run = open('bounce', 0, 480);
    let worst = 0;
    while (run.time < 3) { go(run, 1); worst = Math.max(worst, Math.abs(engine.body(0, 1).r[2] - 0.5 - bounce_height(run.time))); }
    assert(worst < 0.05, `${worst} m`);  // a step late at 7.7 m/s is 16 mm, and there are four bounces
  },
};

let failed = 0;
for (const [name, test] of Object.entries(process.argv.includes('--speed') ? speed : tests)) {
  const begin = performance.now();
  try {
    await test();
    console.log(`ok      ${name}  ${((performance.now() - begin) / 1000).toFixed(1)} s`);
  } catch (error) {
    ++failed;
    console.log(`FAILED  ${name}: ${error.message}\n${error.stack.split('\n').slice(1, 4).join('\n')}`);
  }
}
process.exitCode = failed ? 1 : 0;
