// Packs a run into a link or a file, with everything needed to repeat it. Files of the page's folder are only
// named; the user's files are included. The packed data is deflated: a line of JSON, then the bytes of the
// user's image, if any.

import { flashOf, hexOf } from './image.js';

export const MOST_LINK = 8192;  // characters of the fragment
const MOST_UNPACKED = 4_000_000;
const MAGIC = 'robosim.run/1\n';

const through = (bytes, stream) => new Response(new Blob([bytes]).stream().pipeThrough(stream));

/** Packs a run. The first argument has the values of the form. In it, a user's file is { name, bytes }; any
 *  other file is a name. `hash` is the run's trace hash. Returns null if the image has content outside of
 *  flash. */
export async function packed({ sketch, robot, map, ...more }, hash) {
  const text = (own) => typeof own === 'string' ? own : { name: own.name, text: new TextDecoder().decode(own.bytes) };
  const image = typeof sketch === 'string' ? new Uint8Array() : flashOf(sketch.name, sketch.bytes);
  if (!image) return null;
  const head = { ...more, hash, sketch: sketch.name ?? sketch, own: sketch !== (sketch.name ?? sketch), robot: text(robot), map: text(map) };
  const content = new Blob([JSON.stringify(head), '\n', image]);
  return new Uint8Array(await through(await content.arrayBuffer(), new CompressionStream('deflate-raw')).arrayBuffer());
}

/** Returns the run that packed() received. Throws an Error with a sentence. */
export async function unpacked(bytes) {
  const pieces = [];
  let size = 0;
  try {
    const reader = through(bytes, new DecompressionStream('deflate-raw')).body.getReader();
    for (let piece; !(piece = await reader.read()).done && size <= MOST_UNPACKED; size += piece.value.length) pieces.push(piece.value);
    if (size > MOST_UNPACKED) throw new Error('too much');
    const content = new Uint8Array(await new Blob(pieces).arrayBuffer());
    const end = content.indexOf(10);
    const { sketch, own, robot, map, ...more } = JSON.parse(new TextDecoder().decode(content.subarray(0, end)));
    const plain = (name) => name.replace(/[^\w. -]/g, '_');  // becomes a file's name
    const encoded = (part) => typeof part === 'string' ? part : { name: plain(part.name), bytes: new TextEncoder().encode(part.text) };
    const image = own && { name: `${plain(sketch).replace(/\.\w+$/, '')}.hex`, bytes: new TextEncoder().encode(hexOf(content.subarray(end + 1))) };
    return { ...more, sketch: image || sketch, robot: encoded(robot), map: encoded(map) };
  } catch {
    throw new Error('This shared run is damaged or cut off: ask for it again, as a file.');
  }
}

export function toLink(bytes) {
  const base64 = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
  return base64.replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

export function ofLink(text) {
  try {
    return Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (c) => c.charCodeAt(0));
  } catch {
    return new Uint8Array();
  }
}

export const toFile = (bytes) => new Blob([MAGIC, bytes]);

/** Returns the content of a file of a shared run; null for other files. */
export function ofFile(bytes) {
  const begins = new TextDecoder('latin1').decode(bytes.subarray(0, MAGIC.length)) === MAGIC;
  return begins ? bytes.subarray(MAGIC.length) : null;
}
