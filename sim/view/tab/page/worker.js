// Runs sketches in a worker, so that the page stays responsive: a run is a single call that returns at the
// end of the run.
importScripts('robosim.js', 'runs.js');

const MAGIC = 'robosim.rec/1\n';

/** Returns the bytes of a .rec with this content (docs/reference/recordings.md). */
async function rec(content) {
  const stream = new Blob([content]).stream().pipeThrough(new CompressionStream('deflate'));
  const packed = await new Response(stream).blob();
  return new Uint8Array(await new Blob([MAGIC, packed]).arrayBuffer());
}

let bench, hear;  // hear() receives the progress of the current run

onmessage = async ({ data: { robots, files, request, silent } }) => {
  const tell = silent ? () => {} : postMessage;
  try {
    bench ??= await Bench.make(robots, { reached: (seconds) => hear({ reached: seconds }) });
    hear = tell;
    const began = performance.now();
    const { result, error, recording } = bench.run(files, request);
    const took = (performance.now() - began) / 1000;
    tell({ result, error, took, recording: recording && await rec(recording) });
  } catch (error) {
    tell({ error: { kind: 'internal', message: `The run was cut off: ${error.message}` } });
  }
};
