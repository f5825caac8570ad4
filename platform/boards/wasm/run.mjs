// SPDX-License-Identifier: MIT
// node run.mjs program.wasm: runs the module's main() and ends with its status. What the module imports is all that a page has to
// give it too: text out, the end, and a clock (console_wasm.cpp, clock_wasm.cpp).
import {readFileSync} from 'node:fs';

let memory;
const ingot = {
  write(text, bytes) { process.stdout.write(Buffer.from(memory.buffer, text, bytes).toString()); },
  exit(status) { process.exit(status); },
  now_ns() { return process.hrtime.bigint(); },
};
const {instance} = await WebAssembly.instantiate(readFileSync(process.argv[2]), {ingot});
memory = instance.exports.memory;
process.exitCode = instance.exports.__main_void();
