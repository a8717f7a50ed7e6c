// node runs_test.mjs FOLDER COMMAND [SECONDS [SEED …]]: runs every example sketch on every map with these
// seeds. The web page's module (docs/howto/tab.md) in FOLDER and the robosim command simulate each run for
// SECONDS. The trace hash, the verdict with its sentence, and the image's hash must be equal.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { bench, stock } from './bench.mjs';

const [folder, command, seconds = '60', ...seeds] = process.argv.slice(2);
if (!seeds.length) seeds.push('1');
const SCRIPT = { AiNavigator: 'at 1s press start 100ms\n', PonyNavigator: 'at 1s press scan 100ms\n' };

const tab = await bench(folder), { sketches, maps } = stock(folder);
const work = mkdtempSync(join(tmpdir(), 'robosim-tab-'));
let runs = 0, different = 0, simulated = 0, took = 0;
for (const [sketch, { robot, hex }] of Object.entries(sketches)) {
  const script = SCRIPT[sketch] ?? '';
  writeFileSync(join(work, `${sketch}.hex`), hex);
  writeFileSync(join(work, 'script'), script);
  for (const [map, text, seed] of Object.entries(maps).flatMap(([map, text]) => seeds.map((seed) => [map, text, seed]))) {
    writeFileSync(join(work, `${map}.map`), text);
    const files = { [`${sketch}.hex`]: hex, [`${map}.map`]: text };
    const began = performance.now();
    const { result, error } = tab.run(files, { image: `${sketch}.hex`, map: `${map}.map`, robot, seed: Number(seed), for_ns: seconds * 1e9, ...(script && { script }) });
    took += (performance.now() - began) / 1000;
    let told;
    const words = ['run', `${sketch}.hex`, '--map', `${map}.map`, '--robot', robot, '--for', `${seconds}s`, '--seed', seed, '--script', 'script', '--json'];
    try {
      told = execFileSync(command, words, { cwd: work, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] });
    } catch (ended) {  // a missed goal has a nonzero status
      told = ended.stdout;
    }
    const native = told && JSON.parse(told);
    const here = error ? error.message : [result.trace_hash, result.verdict, result.why, result.image_sha256].join('\n  ');
    const there = native ? [native.trace_hash, native.verdict, native.why, native.inputs.image_sha256].join('\n  ') : 'nothing';
    runs++;
    simulated += result?.time_s ?? 0;
    if (here === there) continue;
    different++;
    console.log(`${sketch} on ${map}, seed ${seed}, differs.\nin the tab:\n  ${here}\nby the command:\n  ${there}`);
  }
}
rmSync(work, { recursive: true });
console.log(`${runs} runs, ${different} differ; in the module ${simulated.toFixed(0)} s in ${took.toFixed(0)} s: ${(simulated / took).toFixed(0)} × real time`);
process.exit(different > 0 || runs === 0 ? 1 : 0);
