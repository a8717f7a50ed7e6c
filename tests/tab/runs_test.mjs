// node runs_test.mjs FOLDER COMMAND [SECONDS]: every stock sketch on every map, in the module and by the command of this
// machine, for so many simulated seconds: the trace hash, the verdict with its sentence, and the image's hash must be equal.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import vm from 'node:vm';

const [folder, command, seconds = '60'] = process.argv.slice(2);
const SCRIPT = { AiNavigator: 'at 1s press start 100ms\n', PonyNavigator: 'at 1s press scan 100ms\n' };

globalThis.robosimModule = createRequire(import.meta.url)(resolve(folder, 'robosim.js'));
const Bench = vm.runInThisContext(`${readFileSync(join(folder, 'runs.js'), 'utf8')}\nBench`);
const stock = JSON.parse(readFileSync(join(folder, 'stock.json'), 'utf8'));
const robots = Object.fromEntries(Object.entries(stock.robots).map(([name, { toml }]) => [name, toml]));
const bench = await Bench.make(robots, { wasmBinary: readFileSync(join(folder, 'robosim.wasm')), reached() {} });

const work = mkdtempSync(join(tmpdir(), 'robosim-tab-'));
let runs = 0, different = 0, simulated = 0, took = 0;
for (const [sketch, { robot, hex }] of Object.entries(stock.sketches)) {
  const script = SCRIPT[sketch] ?? '';
  writeFileSync(join(work, `${sketch}.hex`), hex);
  writeFileSync(join(work, 'script'), script);
  for (const [map, text] of Object.entries(stock.maps)) {
    writeFileSync(join(work, `${map}.map`), text);
    const files = { [`${sketch}.hex`]: hex, [`${map}.map`]: text };
    const began = performance.now();
    const { result, error } = bench.run(files, { image: `${sketch}.hex`, map: `${map}.map`, robot, for_ns: seconds * 1e9, ...(script && { script }) });
    took += (performance.now() - began) / 1000;
    let text_of;
    const words = ['run', `${sketch}.hex`, '--map', `${map}.map`, '--robot', robot, '--for', `${seconds}s`, '--script', 'script', '--json'];
    try {
      text_of = execFileSync(command, words, { cwd: work, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] });
    } catch (ended) {  // a goal that is not reached has a status of its own
      text_of = ended.stdout;
    }
    const native = text_of && JSON.parse(text_of);
    const here = error ? error.message : [result.trace_hash, result.verdict, result.why, result.image_sha256].join('\n  ');
    const there = native ? [native.trace_hash, native.verdict, native.why, native.inputs.image_sha256].join('\n  ') : 'nothing';
    runs++;
    simulated += result?.time_s ?? 0;
    if (here === there) continue;
    different++;
    console.log(`${sketch} on ${map} differs.\nin the tab:\n  ${here}\nby the command:\n  ${there}`);
  }
}
rmSync(work, { recursive: true });
console.log(`${runs} runs, ${different} differ; in the module ${simulated.toFixed(0)} s in ${took.toFixed(0)} s: ${(simulated / took).toFixed(0)} × real time`);
process.exit(different > 0 || runs === 0 ? 1 : 0);
