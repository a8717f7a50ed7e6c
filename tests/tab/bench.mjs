// Loads the WebAssembly module of the web page (docs/howto/tab.md) from its build folder into Node.js.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import vm from 'node:vm';

export const stock = (folder) => JSON.parse(readFileSync(join(folder, 'stock.json'), 'utf8'));

export async function bench(folder) {
  globalThis.robosimModule = createRequire(import.meta.url)(resolve(folder, 'robosim.js'));
  const Bench = vm.runInThisContext(`${readFileSync(join(folder, 'runs.js'), 'utf8')}\nBench`);
  const robots = Object.fromEntries(Object.entries(stock(folder).robots).map(([name, { toml }]) => [name, toml]));
  return Bench.make(robots, { wasmBinary: readFileSync(join(folder, 'robosim.wasm')), reached() {} });
}
