// node folder.mjs SOURCE BUILD OUT SKETCH:ROBOT…
//
// Assembles the folder for a static host. It contains the page of sim/view/tab/page, the module and the replay's page from
// the build, and licences. It also contains stock.json with all sketches, robots and maps, and the service worker with
// the list of all files.
import { createHash } from 'node:crypto';
import { copyFileSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';

const [source, build, out, ...sketches] = process.argv.slice(2);
const page = `${source}/sim/view/tab/page`;
const read = (file) => readFileSync(file, 'utf8');
const stems = (folder, ending) => readdirSync(folder).filter((name) => name.endsWith(ending)).sort().map((name) => name.slice(0, -ending.length));

const robotFile = (name) => `${source}/sim/robot/stock/${name}.toml`;
function boardOf(robot) {
  const value = (key) => new RegExp(`^${key} *= *"(.*)"`, 'm').exec(read(robotFile(robot)))?.[1];
  return value('board') ?? boardOf(value('base'));
}

const robots = {}, maps = {}, images = {};
for (const name of stems(`${source}/sim/robot/stock`, '.toml')) robots[name] = { board: boardOf(name), toml: read(robotFile(name)) };
for (const name of stems(`${source}/maps`, '.map')) maps[name] = read(`${source}/maps/${name}.map`);
for (const [name, robot] of sketches.map((sketch) => sketch.split(':')))
  images[name] = { robot, board: boardOf(robot), hex: read(`${build}/sketches/${name}.hex`) };

rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
for (const name of readdirSync(page)) if (name !== 'sw.js') copyFileSync(`${page}/${name}`, `${out}/${name}`);
copyFileSync(`${source}/sim/view/serve/page/hands.js`, `${out}/hands.js`);
for (const name of ['robosim.js', 'robosim.wasm', 'replay.html']) copyFileSync(`${build}/${name}`, `${out}/${name}`);
writeFileSync(`${out}/licences.txt`, ['robosim-tab', 'robosim'].map((name) => read(`${source}/toolchain/licences/${name}.copyright`)).join(''));
writeFileSync(`${out}/stock.json`, JSON.stringify({ sketches: images, robots, maps }));

const files = readdirSync(out).sort();
const hash = createHash('sha256');
for (const name of files) hash.update(`${name}\n`).update(readFileSync(`${out}/${name}`));
writeFileSync(`${out}/sw.js`, read(`${page}/sw.js`)
  .replace('/* files */', ['./', ...files].map((name) => `'${name}'`).join(', '))
  .replace('/* content */', hash.digest('hex').slice(0, 16)));

const sizes = readdirSync(out).map((name) => [name, gzipSync(readFileSync(`${out}/${name}`), { level: 9 }).length]);
const sum = sizes.reduce((all, [, bytes]) => all + bytes, 0);
console.log(`${out}: ${sum} bytes by gzip -9 (${sizes.map(([name, bytes]) => `${name} ${bytes}`).join(', ')})`);
