// Helpers for programs that run on any emulator, on the chip and on the target host, and report bytes. A
// write to GPIOR0 reports the byte, and a write to GPIOR1 ends the program. A program begins with comments:
//
//   // The required behaviour, as a sentence.
//   // Source: DS40002061B, 15.7.2
//   // Expect: 05 05 ff          bytes in hex; `..` matches any byte
//   // Ends: 20000               optional: cycle limit; default 100000
//   // Chips: atmega2560         optional: chips with this behaviour; main.cpp uses only the first
//   // Loop: 0                   optional: connects TX of USART 0 to its RX
//   // Host: cycles              optional: why the program fails on the host (kHostReasons in program.cpp)
//
// Programs are compiled by avr-gcc -Os with C's start-up code, without an Arduino core. A call of report()
// takes one OUT. For the host, programs are compiled like a sketch; host.h has the helpers.
#pragma once

#include <avr/builtins.h>
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <avr/wdt.h>
#include <stdint.h>

#ifdef ROBOSIM
#include "host.h"
#else

static inline __attribute__((always_inline)) void report(uint8_t byte) { GPIOR0 = byte; }
static inline __attribute__((noreturn)) void end_program(void) {
  GPIOR1 = 1;
  for (;;) {
  }
}
/// Spends `count` cycles (at least 1) with NOPs, without a loop.
#define NOPS(count) __asm__ volatile(".rept " #count "\n\tnop\n\t.endr")
/// The number of cycles that a read of one of the first 64 I/O registers takes.
#define IN_TAKES 1

#endif

static inline __attribute__((always_inline)) void report_word(uint16_t word) {
  report((uint8_t)(word >> 8));
  report((uint8_t)word);
}
