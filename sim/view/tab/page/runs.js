// Runs sketches with the WebAssembly module (sim/view/tab/run.cpp). Writes the files that a run needs to the
// module's file system. This is a script, not a JavaScript module, so that the worker and tests can load it.

class Bench {
  /** `robots` contains the texts of the stock robots by name. `options` are the module's options; the module
   *  calls `reached` with the simulated seconds. */
  static async make(robots, options) {
    const bench = new Bench();
    bench.module = await robosimModule(options);
    const { FS } = bench.module;
    FS.mkdirTree('/robosim/sim/robot/stock');  // where the module expects them
    for (const [name, text] of Object.entries(robots)) FS.writeFile(`/robosim/sim/robot/stock/${name}.toml`, text);
    FS.mkdir('/run');
    FS.chdir('/run');
    return bench;
  }

  /** Runs a `request` (docs/reference/runner-protocol.md). `files` contains the files that the request names.
   *  Returns { result } or { error }, and `recording`: the content of a .rec before compression. */
  run(files, request) {
    const { FS, cwrap, _robosim_recording, _robosim_recording_size } = this.module;
    for (const name of FS.readdir('/run')) if (FS.isFile(FS.stat(`/run/${name}`).mode)) FS.unlink(`/run/${name}`);
    for (const [name, content] of Object.entries(files)) FS.writeFile(`/run/${name}`, content);
    const line = cwrap('robosim_run', 'string', ['string'])(JSON.stringify({ id: 1, do: 'run', ...request }));
    const { result, error } = JSON.parse(line);
    const at = _robosim_recording(), size = _robosim_recording_size();
    return { result, error, recording: result && this.module.HEAPU8.slice(at, at + size) };
  }
}
