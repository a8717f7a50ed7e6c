// node sentences_test.mjs FOLDER COMMAND: checks that the web page (docs/howto/tab.md) rejects wrong files
// with the same messages as the robosim command. Page and command must also read numbers in the same way.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { bench, stock } from './bench.mjs';

const [folder, command] = process.argv.slice(2);
const { hex } = stock(folder).sketches.PidFollower, map = stock(folder).maps.oval;
const mass = (text) => ({ 'r.toml': `base = "uno5"\n[chassis]\nmass = "${text}"\n` });
const elf = (change) => {
  const bytes = new Uint8Array(200);
  bytes.set([0x7f, 0x45, 0x4c, 0x46, 1, 1, 1]);
  const view = new DataView(bytes.buffer);
  [[16, 2], [18, 83], [40, 52], [42, 32], [46, 40]].forEach(([at, value]) => view.setUint16(at, value, true));
  change(view);
  return { 'i.elf': bytes };
};

const CASES = [
  { 'm.map': '####\n#S?#\n####\n' }, { 'm.map': '' }, { 'm.map': '+++\nname = 3\n+++\n...\n' }, { 'm.map': '+++\ncell = "1e400 mm"\n+++\n_S..\n' },
  { 'r.toml': 'board = "unoo"\n' }, { 'r.toml': 'board = \n' }, { 'r.toml': 'base = "uno7"\n' }, { 'r.toml': 'base = "./other.toml"\n' }, { 'r.toml': 'board = "bluepill"\n' },
  ...['-1 kg', '1e-400 kg', '1e400 kg', '0x1 kg', '.7e0kg', '7.e-1 kg', '1e kg', '1.2.3 kg', 'inf kg', '+0.7 kg', ' 700 g', '0,7 kg', 'kg', '1e+ kg'].map(mass),
  { 'i.hex': ':10zz\n' }, { 'i.hex': '' }, { 'i.hex': `${hex.split('\n').slice(0, 9).join('\n')}\n` }, { 'i.hex': ':00000001FF\n' }, { 'i.hex': ':02FFFE00123400\n:00000001FF\n' },
  elf(() => {}), elf((view) => view.setUint16(16, 1, true)), elf((view) => view.setUint16(18, 40, true)), elf((view) => view.setUint16(18, 62, true)),
  ...[4, 5, 6].map((at) => elf((view) => view.setUint8(at, 2))), { 'i.elf': '' }, { 'i.elf': 'no program' },
  elf((view) => { view.setUint16(44, 9, true); view.setUint32(28, 100, true); }), elf((view) => view.setUint16(48, 3, true)),
  elf((view) => { view.setUint16(44, 1, true); view.setUint32(28, 52, true); [1, 84, 0, 0, 900].forEach((value, i) => view.setUint32(52 + 4 * i, value, true)); }),
  { 'i.hex': hex, script: 'at 1s press nothing\n' }, { 'i.hex': hex, script: 'soon\n' },
];

const tab = await bench(folder);
let different = 0;
for (const changed of CASES) {
  const { script, ...own } = changed;
  const files = { 'i.hex': hex, 'm.map': map, 'r.toml': 'base = "uno5"\n', ...own };
  const image = 'i.elf' in files ? 'i.elf' : 'i.hex';
  const { result, error } = tab.run(files, { image, map: 'm.map', robot: 'r.toml', for_ns: 1e8, ...(script && { script }) });
  const here = error ? error.message : result.trace_hash;

  const work = mkdtempSync(join(tmpdir(), 'robosim-tab-'));
  for (const [name, content] of Object.entries({ ...files, script: script ?? '' })) writeFileSync(join(work, name), content);
  const words = ['run', image, '--map', 'm.map', '--robot', 'r.toml', '--for', '100ms', '--json', '--target', 'avr', '--script', 'script'];
  let there;
  try {
    there = JSON.parse(execFileSync(command, words, { cwd: work, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] })).trace_hash;
  } catch ({ stdout, stderr, status }) {
    there = status === 2 ? stderr.replace(/^robosim: /, '').trimEnd() : JSON.parse(stdout).trace_hash;
  }
  rmSync(work, { recursive: true });
  if (here === there) continue;
  different++;
  console.log(`${Object.keys(own)} with ${JSON.stringify(Object.values(changed)[0]).slice(0, 60)}\n  in the tab: ${here}\n  by the command: ${there}`);
}
console.log(`${CASES.length} files, ${different} told otherwise`);
process.exit(different > 0 ? 1 : 0);
