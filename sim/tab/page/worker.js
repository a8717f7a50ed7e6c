// Runs beside the page, so that the page stays alive: a run is one call that returns at its end.
importScripts('robosim.js', 'runs.js');

const MAGIC = 'robosim.rec/1\n';

/** The bytes of a .rec (docs/recordings.md). */
async function rec(content) {
  const stream = new Blob([content]).stream().pipeThrough(new CompressionStream('deflate'));
  const packed = await new Response(stream).blob();
  return new Uint8Array(await new Blob([MAGIC, packed]).arrayBuffer());
}

let bench;

onmessage = async ({ data: { robots, files, request } }) => {
  try {
    bench ??= await Bench.make(robots, { reached: (seconds) => postMessage({ reached: seconds }) });
    if (!request) return;  // only to be ready
    const began = performance.now();
    const { result, error, recording } = bench.run(files, request);
    const took = (performance.now() - began) / 1000;
    postMessage({ result, error, took, recording: recording && await rec(recording) });
  } catch (error) {
    postMessage({ error: { kind: 'internal', message: `The run was cut off: ${error.message}` } });
  }
};
