// node elf_test.mjs FOLDER COMMAND [FILES]: runs FILES (default 100) .elf files that are cut off or have a
// changed byte. The web page's module (docs/howto/tab.md) in FOLDER reads the files without libelf, and the
// robosim command reads them with libelf. Both must refuse a file with the same message, or run it to the
// same trace.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { bench, stock } from './bench.mjs';

const [folder, command, tries = '100'] = process.argv.slice(2);
const work = mkdtempSync(join(tmpdir(), 'robosim-tab-'));
const map = stock(folder).maps.oval;
execFileSync(command, ['build', 'PidFollower', '--target', 'avr', '--out', work], { stdio: 'ignore' });
const whole = readFileSync(join(work, 'PidFollower.elf'));
writeFileSync(join(work, 'm.map'), map);

let seed = 1;
const below = (most) => (seed = (seed * 48271) % 2147483647) % most;

const view = new DataView(whole.buffer, whole.byteOffset, whole.byteLength);
const sections = view.getUint32(32, true), count = view.getUint16(48, true);
/** Returns the offset of a random byte in the ELF file's header, segment table or section table. */
const told = () => {
  const kind = below(3);
  if (kind === 0) return below(52);
  if (kind === 1) return view.getUint32(28, true) + below(32 * view.getUint16(44, true));
  const section = below(count);
  const isNote = view.getUint32(sections + 40 * section + 4, true) === 7;  // a note names the chip;
                                                                           // not checked here
  return isNote ? told() : sections + 40 * section + below(40);
};
function damaged(n) {
  if (n === 0) return whole;
  if (n % 4 === 0) return whole.subarray(0, below(whole.length));
  const bytes = Uint8Array.from(whole);
  bytes[told()] = below(2) ? 255 : below(256);
  return bytes;
}

function native() {
  try {
    const words = ['run', 'i.elf', '--map', 'm.map', '--robot', 'uno5', '--for', '100ms', '--json', '--target', 'avr'];
    return JSON.parse(execFileSync(command, words, { cwd: work, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] })).trace_hash;
  } catch ({ stdout, stderr, status }) {
    return status === 2 ? `refused: ${stderr.replace(/^robosim: /, '').trim()}` : JSON.parse(stdout).trace_hash;
  }
}

const tab = await bench(folder);
let different = 0, refused = 0;
for (let n = 0; n < Number(tries); n++) {
  const bytes = damaged(n);
  writeFileSync(join(work, 'i.elf'), bytes);
  const { result, error } = tab.run({ 'i.elf': bytes, 'm.map': map }, { image: 'i.elf', map: 'm.map', robot: 'uno5', for_ns: 1e8 });
  const here = error ? `refused: ${error.message}` : result.trace_hash, there = native();
  refused += here === there && here.startsWith('refused');
  if (here === there) continue;
  different++;
  const at = whole.findIndex((byte, i) => byte !== bytes[i]);
  console.log(`try ${n} (${bytes.length} of ${whole.length} bytes; byte ${at} is ${bytes[at]}, was ${whole[at]})\n  in the tab: ${here}\n  by the command: ${there}`);
}
rmSync(work, { recursive: true });
console.log(`${tries} files, ${refused} refused by both, ${different} told otherwise`);
process.exit(different > 0 || refused === 0 ? 1 : 0);
