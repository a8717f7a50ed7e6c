// Helpers for programs that run on any emulator and on the chip, and report bytes. A write to GPIOR0 reports
// the byte, and a write to GPIOR1 ends the program. A program begins with comments:
//
//   // The required behaviour, as a sentence.
//   // Source: DS40002061B, 15.7.2
//   // Expect: 05 05 ff          bytes in hex; `..` matches any byte
//   // Ends: 20000               optional: cycle limit; default 100000
//   // Chips: atmega2560         optional: chips with this behaviour; foreign emulators test only the first
//   // Loop: 0                   optional: connects TX of USART 0 to its RX
//
// Programs are compiled by avr-gcc -Os with C's start-up code, without an Arduino core. A call of report()
// takes one OUT.
#pragma once

#include <avr/interrupt.h>
#include <avr/io.h>
#include <stdint.h>

static inline __attribute__((always_inline)) void report(uint8_t byte) { GPIOR0 = byte; }
static inline __attribute__((always_inline)) void report_word(uint16_t word) {
  GPIOR0 = (uint8_t)(word >> 8);
  GPIOR0 = (uint8_t)word;
}
static inline __attribute__((noreturn)) void end_program(void) {
  GPIOR1 = 1;
  for (;;) {
  }
}
/// Spends `count` cycles (at least 1) with NOPs, without a loop.
#define NOPS(count) __asm__ volatile(".rept " #count "\n\tnop\n\t.endr")
