// Converts firmware images to flash content, the bytes from address 0 on, and back. A link contains the flash
// content instead of the image, because it is shorter.

const kData = 0, kEnd = 1, kSegment = 2, kUpper = 4;
const SECOND = 0x800000;  // avr-gcc puts all memories except flash from here on (sim/base/elf/avr_addresses.h)

const filled = (parts) => {
  const size = parts.reduce((most, { at, bytes }) => Math.max(most, at + bytes.length), 0);
  const flash = new Uint8Array(size).fill(0xff);
  for (const { at, bytes } of parts) flash.set(bytes, at);
  return flash;
};

/** Returns the flash content of an Intel HEX file. Does not check the file, because it has already run. */
function ofHex(text) {
  const parts = [];
  let base = 0;
  for (const line of text.split(/\r?\n/)) {
    const bytes = Uint8Array.from(line.trim().slice(1).match(/../g) ?? [], (pair) => parseInt(pair, 16));
    const [, high, low, kind] = bytes, value = bytes[4] << 8 | bytes[5];
    if (kind === kEnd) break;
    if (kind === kSegment) base = value << 4;
    if (kind === kUpper) base = value * 65536;
    if (kind === kData) parts.push({ at: base + (high << 8 | low), bytes: bytes.subarray(4, -1) });
  }
  return filled(parts);
}

/** Returns the flash content of an ELF file; null if the file also has content for the EEPROM. Does not check
 *  the file, because it has already run. */
function ofElf(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const parts = [], table = view.getUint32(28, true);
  for (let i = 0; i < view.getUint16(44, true); i++) {
    const [type, offset, , address, size] = Array.from({ length: 5 }, (_, k) => view.getUint32(table + 32 * i + 4 * k, true));
    if (type !== 1 || !size) continue;
    if (address < SECOND) parts.push({ at: address, bytes: bytes.subarray(offset, offset + size) });
    else if (address < 0x820000 && address >= 0x810000) return null;
  }
  return filled(parts);
}

export const flashOf = (name, bytes) => name.endsWith('.hex') ? ofHex(new TextDecoder().decode(bytes)) : ofElf(bytes);

/** Returns an Intel HEX file in Arduino's layout. */
export function hexOf(flash) {
  const hex = (byte) => byte.toString(16).toUpperCase().padStart(2, '0');
  const line = (address, kind, data) => {
    const bytes = [data.length, address >> 8 & 255, address & 255, kind, ...data];
    return `:${bytes.map(hex).join('')}${hex(-bytes.reduce((sum, byte) => sum + byte, 0) & 255)}\n`;
  };
  let text = '';
  for (let at = 0; at < flash.length; at += 16) {
    if (at && at % 65536 === 0) text += line(0, kUpper, [at >> 24 & 255, at >> 16 & 255]);
    text += line(at & 65535, kData, flash.subarray(at, at + 16));
  }
  return text + line(0, kEnd, []);
}
