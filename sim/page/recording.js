// Reads a recording (docs/recordings.md has the format): a line that says what it is, then, compressed, a line
// of JSON and the columns that it lists.

const MAGIC = 'robosim.rec/1\n';

/** Something is wrong with a file; its message is a sentence for people. */
export class BadFile extends Error {}

export function bytesOfBase64(text) {
  let binary;
  try {
    binary = atob(text.trim());
  } catch {
    throw new BadFile('The recording in this page is damaged: record the run again.');
  }
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

async function inflated(bytes) {
  try {
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  } catch {
    throw new BadFile('The recording is damaged or cut off: record the run again.');
  }
}

/** Whole numbers, of which differences are kept in groups of seven bits (sim/wire/columns.h). `before`: where the numbers
 *  before these have ended, and these will. */
export function column(bytes, at, { bytes: size, order, scale, name }, count, before = { last: 0, change: 0 }) {
  const values = new Float64Array(count);
  const end = at + size;
  const bad = () => new BadFile(`The recording's column ${name} is damaged: record the run again.`);
  if (end > bytes.length) throw bad();
  let { last, change } = before;
  for (let i = 0; i < count; i++) {
    if (at >= end) throw bad();
    let byte = bytes[at++], z = byte & 127;
    for (let factor = 128; byte > 127; factor *= 128) {
      if (at >= end) throw bad();
      byte = bytes[at++];
      z += (byte & 127) * factor;
    }
    const d = z % 2 ? -(z + 1) / 2 : z / 2;
    change = order === 2 ? change + d : d;
    last += change;
    values[i] = last / scale;
  }
  if (at !== end) throw bad();
  Object.assign(before, { last, change });
  return values;
}

/** The rows of a stream, by column; in the order of time. */
function inOrder(stream, key) {
  const times = stream[key];
  if (!times || times.every((t, i) => i === 0 || t >= times[i - 1])) return stream;
  const rows = Array.from(times.keys()).sort((a, b) => times[a] - times[b] || a - b);
  for (const name of Object.keys(stream))
    if (stream[name] instanceof Float64Array) stream[name] = Float64Array.from(rows, (i) => stream[name][i]);
  return stream;
}

/** { header, streams: Map of name to { columnName: Float64Array, text? }, others: the same of further robots } */
export async function readRecording(bytes) {
  const begins = new TextDecoder('latin1').decode(bytes.subarray(0, MAGIC.length));
  if (begins !== MAGIC) {
    throw new BadFile(begins.startsWith('robosim.rec/')
      ? 'This recording is of a newer version of Robosim than this page.'
      : 'This is no recording of Robosim’s.');
  }
  const all = await inflated(bytes.subarray(MAGIC.length));
  const end = all.indexOf(10);
  const utf8 = new TextDecoder();
  let header;
  try {
    header = JSON.parse(utf8.decode(all.subarray(0, end)));
  } catch {
    throw new BadFile('The recording’s header is damaged: record the run again.');
  }
  let at = end + 1;
  const read = (infos) => {
    const streams = new Map();
    for (const { name, count, columns } of infos) {
      const stream = {};
      for (const info of columns) {
        if (info.order === 0) stream[info.name] = utf8.decode(all.subarray(at, at + info.bytes));
        else stream[info.name] = column(all, at, info, count);
        if (info.order === 0) stream.utf8 = all.subarray(at, at + info.bytes);
        at += info.bytes;
      }
      streams.set(name, inOrder(stream, 't_ns'));
    }
    return streams;
  };
  const streams = read(header.streams);
  const others = (header.others ?? []).map((own) => ({ header: { ...shared(header), ...own }, streams: read(own.streams) }));
  return { header, streams, others };
}

/** What a recording says once for all its robots. */
export function shared({ robosim, map, map_text, floor, notes }) { return { robosim, map, map_text, floor, notes }; }

/** The recording inside another page of ours. */
export function bytesOfPage(html) {
  const found = /<script id="recording"[^>]*>([^<]*)<\/script>/.exec(html);
  if (!found) throw new BadFile('This page holds no recording of Robosim’s.');
  return bytesOfBase64(found[1]);
}
