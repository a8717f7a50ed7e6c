// node avr8js.mjs FOLDER FLASH.bin CYCLES LOOP: runs a program of tests/conformance/avr on the avr8js in
// FOLDER (`npm install avr8js`). Prints "ended" or "stopped", and the bytes that the program reported.
import { createRequire } from 'node:module';
import { readFileSync } from 'node:fs';

const [folder, image, cycles, loop] = process.argv.slice(2);
const require = createRequire(`${folder}/package.json`);
const avr = require('avr8js');

const flash = readFileSync(image);
const words = new Uint16Array(0x4000).fill(0xffff);
for (let i = 0; i < flash.length; i += 2) words[i >> 1] = flash[i] | ((flash[i + 1] ?? 0xff) << 8);
const cpu = new avr.CPU(words);
new avr.AVRTimer(cpu, avr.timer0Config);
new avr.AVRTimer(cpu, avr.timer1Config);
new avr.AVRTimer(cpu, avr.timer2Config);
for (const port of [avr.portBConfig, avr.portCConfig, avr.portDConfig]) new avr.AVRIOPort(cpu, port);
const usart = new avr.AVRUSART(cpu, avr.usart0Config, 16e6);
if (loop === '0') usart.onByteTransmit = (byte) => usart.writeByte(byte, true);
new avr.AVRADC(cpu, avr.adcConfig);
new avr.AVRClock(cpu, 16e6);
new avr.AVREEPROM(cpu, new avr.EEPROMMemoryBackend(1024));
new avr.AVRSPI(cpu, avr.spiConfig, 16e6);
new avr.AVRTWI(cpu, avr.twiConfig, 16e6);
if (avr.AVRWatchdog) new avr.AVRWatchdog(cpu, avr.watchdogConfig, new avr.AVRClock(cpu, 16e6));

const reported = [];
let ended = false;
cpu.writeHooks[0x3e] = (value) => { reported.push(value); };
cpu.writeHooks[0x4a] = () => { ended = true; };
while (!ended && cpu.cycles < Number(cycles)) {
  avr.avrInstruction(cpu);
  cpu.tick();
}
console.log([ended ? 'ended' : 'stopped', ...reported.map((b) => b.toString(16).padStart(2, '0'))].join(' '));
