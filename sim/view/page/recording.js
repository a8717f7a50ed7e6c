// Reads a recording (docs/reference/recordings.md describes the format): a line that identifies the format,
// then compressed data. The data is a line of JSON, and the columns that it lists.

const MAGIC = 'robosim.rec/1\n';

/** An error in a file. Its message is a sentence for the user. */
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

/** Decodes whole numbers, stored as differences in groups of seven bits (sim/wire/columns.h). `before` is the
 *  decoder's state after the previous numbers, and is updated. */
export function column(bytes, at, { bytes: size, order, scale, name }, count, before = { last: 0, change: 0 }) {
  const values = new Float64Array(count);
  const end = at + size;
  const bad = () => new BadFile(`The recording's column ${name} is damaged: record the run again.`);
  if (end > bytes.length) throw bad();
  let { last, change } = before;
  for (let i = 0; i < count; i++) {
    if (at >= end) throw bad();
    let byte = bytes[at++], d;
    if (byte < 128) {
      d = (byte >> 1) ^ -(byte & 1);  // the most frequent case
    } else {
      let z = byte & 127;
      for (let factor = 128; byte > 127; factor *= 128) {
        if (at >= end) throw bad();
        byte = bytes[at++];
        z += (byte & 127) * factor;
      }
      d = z % 2 ? -(z + 1) / 2 : z / 2;
    }
    change = order === 2 ? change + d : d;
    last += change;
    values[i] = last / scale;
  }
  if (at !== end) throw bad();
  Object.assign(before, { last, change });
  return values;
}

/** Returns whether a column has as many numbers as there are rows. */
function isWhole(bytes, at, { bytes: size }, count) {
  const end = at + size;
  let numbers = 0;
  if (end > bytes.length) return false;
  for (let i = at; i < end; i++) numbers += 1 - (bytes[i] >> 7);
  return numbers === count && (size === 0 || bytes[end - 1] < 128);
}

/** Defines a property that is computed on first access. */
export function lazily(object, name, make) {
  const set = (value) => Object.defineProperty(object, name, { value, writable: true, enumerable: true, configurable: true });
  Object.defineProperty(object, name, { get: () => set(make())[name], set, enumerable: true, configurable: true });
}

/** Returns the columns of a stream, with its rows in the order of time. Each column is decoded on first access: an
 *  hour has millions of numbers, of which few are used. */
function streamOf(bytes, at, count, columns) {
  const stream = {};
  let rows;  // indices in the order of time; null = already in order
  const inOrder = (values) => (rows ? Float64Array.from(rows, (i) => values[i]) : values);
  const order = () => {
    if (rows !== undefined) return;
    rows = null;
    const i = columns.findIndex(({ name }) => name === 't_ns');
    if (i < 0) return;
    const times = column(bytes, places[i], columns[i], count);
    if (!times.every((t, k) => k === 0 || t >= times[k - 1]))
      rows = Array.from(times.keys()).sort((a, b) => times[a] - times[b] || a - b);
  };
  const places = [];
  for (const info of columns) {
    const place = at;
    places.push(place);
    at += info.bytes;
    if (info.order === 0) {
      stream.utf8 = bytes.subarray(place, at);
      stream[info.name] = new TextDecoder().decode(stream.utf8);
    } else {
      if (!isWhole(bytes, place, info, count)) throw new BadFile(`The recording's column ${info.name} is damaged: record the run again.`);
      lazily(stream, info.name, () => { order(); return inOrder(column(bytes, place, info, count)); });
    }
  }
  return stream;
}

/** Returns whether a header has everything that is needed to draw its robot. */
function isRobot({ result, started, robot_info: robot, streams }) {
  const isStream = ({ name, columns }) => Array.isArray(columns) && (name !== 'samples' || ['t_us', 'x_mm', 'y_mm', 'yaw_rad'].every((one) => columns.some((column) => column.name === one)));
  return Number.isFinite(result?.time_s) && [started?.readings, robot?.sensors, streams].every(Array.isArray) && streams.every(isStream);
}

/** Returns { header, streams: Map of name to { columnName: Float64Array, text? }, others: { header, streams } of
 *  each further robot }. */
export async function readRecording(bytes) {
  const begins = new TextDecoder('latin1').decode(bytes.subarray(0, MAGIC.length));
  if (begins !== MAGIC) {
    throw new BadFile(begins.startsWith('robosim.rec/')
      ? 'This recording was made by a newer version of Robosim than this page.'
      : 'This is not a recording of Robosim.');
  }
  const all = await inflated(bytes.subarray(MAGIC.length));
  const end = all.indexOf(10);
  let header;
  try {
    header = JSON.parse(new TextDecoder().decode(all.subarray(0, end)));
  } catch {}
  if (!Array.isArray(header?.notes) || ![header, ...(header.others ?? [])].every(isRobot))
    throw new BadFile('The recording’s header is damaged: record the run again.');
  let at = end + 1;
  const read = (infos) => {
    const streams = new Map();
    for (const { name, count, columns } of infos) {
      streams.set(name, streamOf(all, at, count, columns));
      for (const { bytes } of columns) at += bytes;
    }
    return streams;
  };
  const streams = read(header.streams);
  const others = (header.others ?? []).map((own) => ({ header: { ...shared(header), ...own }, streams: read(own.streams) }));
  return { header, streams, others };
}

/** Returns the part of a header that all robots share. */
export function shared({ robosim, map, map_text, floor, notes }) { return { robosim, map, map_text, floor, notes }; }

/** Returns the recording in another page of Robosim. */
export function bytesOfPage(html) {
  const found = /<script id="recording"[^>]*>([^<]*)(<\/script>)?/.exec(html);
  if (!found) throw new BadFile('This page has no recording of Robosim.');
  if (!found[2]) throw new BadFile('This page is cut off inside its recording: record the run again.');
  return bytesOfBase64(found[1]);
}
