// SPDX-License-Identifier: MIT
// node browser_test.mjs viewer.html <folder with node_modules/playwright-core> <chromium> [folder for pictures]: real clicks and keys. Ends with 77
// where one of the two is not there.
import assert from 'node:assert/strict';
import {existsSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

const [, , page_path, packages, program, pictures] = process.argv;
let chromium;
try {
  ({chromium} = createRequire(join(resolve(packages), 'package.json'))('playwright-core'));
} catch { /* below */ }
if (!chromium || !existsSync(program)) {
  console.log('skipped: no playwright-core, or no chromium');
  process.exit(77);
}

const browser = await chromium.launch({executablePath: program, args: ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--no-sandbox']});
const address = pathToFileURL(resolve(page_path)).href;
const faults = [];
async function open(hash = '', options = {}) {
  const page = await browser.newPage({viewport: {width: 1200, height: 760}, ...options});
  page.setDefaultTimeout(300000);  // on a machine with other work a tap may wait for its frame
  page.on('pageerror', error => faults.push(error.message));
  page.on('console', message => { if (message.type() === 'error') faults.push(message.text()); });
  page.on('request', request => { if (!/^(file|data|blob):/.test(request.url())) faults.push(`asks for ${request.url()}`); });
  await page.goto(address + hash);
  await page.waitForFunction(() => globalThis.page && globalThis.page.told, null, {timeout: 120000});
  return page;
}
const at = page => page.evaluate(() => globalThis.page.run.at);
const hash = page => page.evaluate(() => String(globalThis.page.run.hash));
const later = (page, what, argument) => page.waitForFunction(what, argument, {timeout: 120000});
/// Where a body is on the screen, CSS px.
const place = (page, body) => page.evaluate(number => {
  const p = globalThis.page, r = p.engine.body(0, number).r, m = p.renderer.frame(p.camera, 0, 1).matrix, box = p.canvas.getBoundingClientRect();
  const c = [0, 1, 3].map(i => m[i] * r[0] + m[4 + i] * r[1] + m[8 + i] * r[2] + m[12 + i]);
  return {x: box.left + box.width * (1 + c[0] / c[2]) / 2, y: box.top + box.height * (1 - c[1] / c[2]) / 2};
}, body);

const tests = {
  async it_opens_and_moves_and_has_the_native_bits() {
    const page = await open();
    await later(page, () => globalThis.page.run.at > 70);
    await later(page, () => document.getElementById('bits').textContent.includes('Same bits as native'));
    await page.close();
  },
  async pause_step_restart() {
    const page = await open('#scene=tower');
    await page.click('#pause');
    const stood = await at(page);
    await page.waitForTimeout(400);
    assert.equal(await at(page), stood);
    await page.click('#one');
    assert.equal(await at(page), stood + 1);
    await page.keyboard.press('o');
    assert.equal(await at(page), stood + 2);
    await page.keyboard.press('p');
    await later(page, from => globalThis.page.run.at > from + 3, stood);
    await page.keyboard.press('p');
    await page.keyboard.press('r');
    await later(page, () => globalThis.page.run.at > 1);
    assert((await page.textContent('#pause')) === 'Pause');
    await later(page, () => /solving\d+\.\d\d ms/.test(document.getElementById('facts').textContent));
    await page.close();
  },
  async the_mouse_drags_a_body_and_the_replay_has_its_bits() {
    const page = await open('#scene=crate&step=200'), from = await place(page, 1),
          before = await page.evaluate(() => globalThis.page.engine.body(0, 1).r);
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    for (let i = 1; i <= 8; ++i) {
      await page.mouse.move(from.x + 8 * i, from.y - 18 * i);
      await page.waitForTimeout(60);
    }
    await later(page, z => globalThis.page.engine.body(0, 1).r[2] > z + 0.4, before[2]);
    await page.mouse.up();
    await later(page, z => globalThis.page.engine.body(0, 1).r[2] < z + 0.3, before[2]);
    await page.click('#pause');
    const end = await at(page), bits = await hash(page);
    await page.click('#replay');
    assert((await at(page)) < end);
    await page.keyboard.press('p');
    await page.evaluate(step => globalThis.page.seek(step), end);
    assert.equal(await hash(page), bits);
    assert(!(await page.evaluate(() => globalThis.page.run.differs)));
    await page.focus('#scrub');
    await page.keyboard.press('Home');
    assert.equal(await at(page), 0);
    await page.close();
  },
  async a_drag_beside_bodies_looks_around_and_the_wheel_comes_nearer() {
    const page = await open('#scene=crate&step=60'), was = await page.evaluate(() => ({...globalThis.page.camera}));
    await page.mouse.move(300, 600);
    await page.mouse.down();
    await page.mouse.move(380, 560, {steps: 4});
    await page.mouse.up();
    await page.mouse.wheel(0, -400);
    await page.waitForTimeout(100);
    const is = await page.evaluate(() => ({...globalThis.page.camera}));
    assert(is.yaw !== was.yaw && is.pitch !== was.pitch && is.distance < was.distance);
    assert.equal(await page.evaluate(() => globalThis.page.run.inputs.length), 0);
    await page.close();
  },
  async space_shoots_once_and_F_follows() {
    const page = await open('#scene=pyramid&step=10'), count = () => page.evaluate(() => globalThis.page.engine.report(0).bodies),
          before = await count();
    await page.focus('#pause');  // space must not click it too
    await page.keyboard.press(' ');
    assert.equal(await count(), before + 1);
    await page.keyboard.press('f');
    assert.equal(await page.getAttribute('#follow', 'aria-pressed'), 'true');
    assert((await page.textContent('#bits')).length > 16);
    await page.close();
  },
  async the_slider_the_method_and_two_worlds() {
    const page = await open('#scene=flip');
    await page.focus('#rate');
    await page.keyboard.press('End');
    assert.equal(await page.evaluate(() => globalThis.page.run.rate), 1000);
    await page.keyboard.press('Home');
    assert.equal(await page.evaluate(() => globalThis.page.run.rate), 30);
    await page.selectOption('#kind', '7');
    await page.check('#both');
    await page.selectOption('#kind_2', '3');
    assert.equal(await page.evaluate(() => globalThis.page.runs.length), 2);
    await later(page, () => globalThis.page.curve.length > 40);
    const [printed, own] = await page.evaluate(() => globalThis.page.curve[globalThis.page.curve.length - 1].errors);
    assert(printed > 10 * own, `${printed} ${own}`);
    assert((await page.textContent('#error_text')).includes('exact'));
    await page.close();
  },
  async toggles_draw_lines() {
    const page = await open('#scene=bridge&step=60');
    for (const name of ['Joints', 'Contacts', 'Islands', 'Bounds']) await page.check(`[data-show="${name}"]`);
    const lines = await page.evaluate(() => globalThis.page.engine.draw(0, ['joint', 'bounds'], 1).line_count);
    assert(lines > 100);
    await page.close();
  },
  async a_link_names_scene_and_step() {
    const page = await open('#scene=dominoes&step=33&rate=120');
    assert.deepEqual(await page.evaluate(() => [globalThis.page.scene.id, globalThis.page.run.at, globalThis.page.run.rate]), ['dominoes', 33, 120]);
    await page.click('#link');
    assert((await page.evaluate(() => location.hash)) === '#scene=dominoes&step=33&rate=120');
    await page.close();
    const strange = await open('#scene=nothing&step=-4');
    assert.equal(await strange.evaluate(() => globalThis.page.scene.id), 'crate');
    await strange.close();
  },
  async arrow_keys_drive_the_car() {
    const page = await open('#scene=car');
    await page.keyboard.down('ArrowLeft');
    await later(page, () => globalThis.page.run.inputs.length > 0);
    await page.keyboard.up('ArrowLeft');
    assert.equal(await page.evaluate(() => globalThis.page.run.inputs[0].numbers[1]), 1);
    await page.close();
  },
  async every_scene_is_clicked_and_shows_something() {
    const page = await open();
    for (const button of await page.$$('[data-scene]')) {
      await button.click();
      const id = await button.getAttribute('data-scene');
      assert.equal(await page.evaluate(() => globalThis.page.scene.id), id);
      await page.waitForTimeout(300);
      const colors = await page.evaluate(() => {
        const p = globalThis.page, gl = p.renderer.gl;
        p.draw();
        const pixels = new Uint8Array(4 * p.canvas.width * p.canvas.height);
        gl.readPixels(0, 0, p.canvas.width, p.canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        const seen = new Set();
        for (let i = 0; i < pixels.length; i += 64) seen.add(pixels[i] << 16 | pixels[i + 1] << 8 | pixels[i + 2]);
        return seen.size;
      });
      assert(colors > 20, `${id}: ${colors} colours`);
      if (pictures) await page.screenshot({path: join(pictures, `${id}.png`)});
    }
    await page.close();
  },
  async a_finger_drags_a_body_and_two_come_nearer() {
    const page = await open('#scene=crate&step=200', {viewport: {width: 360, height: 700}, hasTouch: true}), from = await place(page, 1);
    const session = await page.context().newCDPSession(page), touch = (type, ...points) => session.send('Input.dispatchTouchEvent', {
      type, touchPoints: points.map(([x, y], id) => ({x, y, id}))});
    const was = await page.evaluate(() => ({z: globalThis.page.engine.body(0, 1).r[2], distance: globalThis.page.camera.distance}));
    await touch('touchStart', [from.x, from.y]);
    for (let i = 1; i <= 6; ++i) { await touch('touchMove', [from.x, from.y - 16 * i]); await page.waitForTimeout(60); }
    await later(page, z => globalThis.page.engine.body(0, 1).r[2] > z + 0.3, was.z);
    await touch('touchEnd');
    await page.tap('#pause');
    const inputs = await page.evaluate(() => globalThis.page.run.inputs.length);
    await touch('touchStart', [30, 320], [60, 320]);
    for (let i = 1; i <= 5; ++i) await touch('touchMove', [30, 320], [60 + 12 * i, 320]);
    await touch('touchEnd');
    assert((await page.evaluate(() => globalThis.page.camera.distance)) < was.distance);
    assert.equal(await page.evaluate(() => globalThis.page.run.inputs.length), inputs);
    await page.close();
  },
  async a_phone_and_the_dark() {
    for (const colorScheme of ['light', 'dark']) {
      const page = await open('#scene=balls&step=30', {viewport: {width: 360, height: 700}, colorScheme, hasTouch: true});
      await page.tap('#pause');
      for (const tab of ['numbers', 'look', 'compare', 'scenes']) {
        await page.tap(`#tabs [data-tab=${tab}]`);
        const wide = await page.evaluate(() => [...document.querySelectorAll('body *')].filter(one => {
          const box = one.getBoundingClientRect();
          return box.width > 0 && (box.right > 361 || box.left < -1);
        }).map(one => one.id || one.tagName));
        assert.deepEqual(wide, [], tab);
        if (pictures) await page.screenshot({path: join(pictures, `phone_${colorScheme}_${tab}.png`)});
      }
      const back = await page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number).reduce((a, b) => a + b));
      assert(colorScheme === 'dark' ? back < 200 : back > 600);
      await page.close();
    }
  },
};

let failed = 0;
for (const [name, test] of Object.entries(tests)) {
  const begin = performance.now();
  try {
    faults.length = 0;
    await test();
    assert.deepEqual(faults, []);
    console.log(`ok      ${name}  ${((performance.now() - begin) / 1000).toFixed(1)} s`);
  } catch (error) {
    ++failed;
    console.log(`FAILED  ${name}: ${error.message}\n${error.stack.split('\n').slice(1, 4).join('\n')}`);
  }
}
await browser.close();
process.exitCode = failed ? 1 : 0;
