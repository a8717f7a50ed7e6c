// For programs that are judged by what they report, on any emulator and on the chip: each byte that is
// written to GPIOR0 is reported, a write to GPIOR1 ends the program. A program begins with comments:
//
//   // What must hold, as a sentence.
//   // Source: DS40002061B, 15.7.2
//   // Expect: 05 05 ff          bytes, in hex; `..` is any
//   // Ends: 20000               optional: cycles after which it is stopped, 100000 unless told
//   // Chips: atmega2560         optional: of which it holds, atmega328p unless told; referees run the first
//   // Loop: 0                   optional: TX of USART 0 is wired to its RX
//
// Compiled by avr-gcc -Os with C's start-up code, without an Arduino core. A call takes one OUT.
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
/// Spends `count` cycles, at least 1, without a loop: NOPs.
#define NOPS(count) __asm__ volatile(".rept " #count "\n\tnop\n\t.endr")
