// node avr8js.mjs FOLDER PROGRAMS: runs the programs of against_avr8js_test.cpp on the avr8js in FOLDER, and
// prints the state after each.
import { createRequire } from 'node:module';
import { readFileSync } from 'node:fs';

const [folder, file] = process.argv.slice(2);
const require = createRequire(`${folder}/package.json`);
const avr = require('avr8js');

const REGISTERS_OF_IO = 0x100, RAMPZ = 0x5b, EIND = 0x5c, SP = 0x5d, SREG = 0x5f, HALF_CARRY = 0x20;
const numbers = (line) => line.trim().split(' ').map(Number);
const [flash, memory, ...programs] = readFileSync(file, 'utf8').trimEnd().split('\n').map(numbers);
const cpu = new avr.CPU(Uint16Array.from(flash), 0x10000 - REGISTERS_OF_IO);
for (const [pc, sreg, sp, rampz, eind, cycles, ...registers] of programs) {
  cpu.data.set(memory);
  cpu.data.set(registers);
  cpu.data[RAMPZ] = rampz;
  cpu.data[EIND] = eind;
  cpu.SP = sp;
  cpu.data[SREG] = sreg;
  cpu.pc = pc;
  cpu.cycles = 0;
  while (cpu.cycles < cycles) avr.avrInstruction(cpu);
  let sum = 0;
  for (let at = 0; at < cpu.data.length; at++)
    if (at < SP || at > SREG) sum = (Math.imul(sum, 31) + cpu.data[at]) >>> 0;
  console.log([cpu.pc, cpu.cycles, cpu.data[SREG] & ~HALF_CARRY, cpu.SP, ...cpu.data.subarray(0, 32), sum].join(' '));
}
