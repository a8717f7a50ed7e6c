// The cost of every Arduino API call on an ATmega328P, in CPU cycles. No other file has these values.
//
// Values marked M were measured: Debian's arduino-core-avr 1.8.7, compiled by gcc-avr 5.4 with -Os -flto, ran
// in libsimavr 1.6. Two writes of GPIOR0 enclose the call. A cost is the number of cycles between these
// writes, minus the number without a call. The arguments of the calls are not constants.
#pragma once

#include <stdint.h>

#include "hal/board/cycle_time.h"
#include "hal/host/chip.h"

namespace robosim {
namespace host {

constexpr CycleTime kCycles(kClockHz);

/// Returns the duration of `count` CPU cycles, in nanoseconds.
constexpr SimTime cycles(int64_t count) { return kCycles.of(count); }

namespace cost {

// The cost of each basic block of the firmware (gcc -O1 on the host). M: a loop's cycles in simavr, divided
// by its blocks on the host, for five loops of line followers. Results: 7.9 (three sensors, if-else), 19.2
// (shortening a maze's path), 19.3 (calibration of five sensors), 276 (weighted position with five long
// divisions), 1421 (PID in floats, one block). kBlock, the rounded median, is about right for decisions and
// loops. It is too low for calculations: at 16 MHz, a long division takes 45 us, a float operation 10 us.
constexpr int kBlock = 20;
constexpr int kLoop = 10;  ///< from one loop() to the next; M: 16, including the body of an empty loop()
constexpr int kInit = 60;  ///< init() in wiring.c, counted in its disassembly

// Digital pins (M). Comments give the measured values.
constexpr int kPinMode = 73;       ///< 70 output, 77 input
constexpr int kDigitalWrite = 73;  ///< 93 on a pin with PWM
constexpr int kDigitalRead = 74;   ///< 94 on a pin with PWM
constexpr int kTimerPin = 20;      ///< added to digitalWrite() and digitalRead() on a pin with PWM
constexpr int kShiftOutBit = 170;  ///< per bit: M 244, minus one digitalWrite
constexpr int kShiftInBit = 104;   ///< per bit: M 251, minus one digitalWrite and one digitalRead

// Analog pins.
constexpr int kAnalogWrite = 128;         ///< M, with PWM
constexpr int kAnalogWriteDigital = 192;  ///< M, for values 0 and 255, and for pins without PWM
/// M: 1706 cycles, minus 13 ADC clocks of 128 cycles. The wait for the ADC's next clock is added, so
/// consecutive reads take 14 ADC clocks, as on real boards (112 us at 16 MHz).
constexpr int kAnalogRead = 42;

// Time (M)
constexpr int kMillis = 19;
constexpr int kMicros = 55;
constexpr int kDelayEnd = 85;   ///< delay(10) took 160,154 cycles, 69 of them in the first call of micros()
constexpr int kDelayPoll = 30;  ///< one round of delay()'s loop, without its micros()
constexpr int kPulseWait = 11;  ///< one round before the pulse; the core assumes 16, so timeouts come early
constexpr int kPulseLoop = 16;  ///< one round of the loop that measures the pulse

// Interrupts (M)
constexpr int kInterrupt = 30;        ///< entry and return of an ISR(), and saving registers
constexpr int kAttachedHandler = 50;  ///< added for a handler passed to attachInterrupt()
constexpr int kTimer0Overflow = 96;   ///< the whole handler, every 64 * 256 cycles
constexpr int kAttachInterrupt = 13;

// Mathematics (M)
constexpr int kMap = 687;
constexpr int kRandom = 810;       ///< random(), rand()
constexpr int kRandomBelow = 590;  ///< added for random(below)

// Serial (M)
constexpr int kSerialBegin = 161;
constexpr int kSerialWrite = 88;
constexpr int kSerialTransmitHandler = 122;
constexpr int kSerialReceiveHandler = 45;  ///< counted in the handler's disassembly, minus kInterrupt
constexpr int kSerialNumber = 130;         ///< print(number): cost per call, without its digits
constexpr int kSerialDigit = 615;  ///< print(number): per digit, plus its write(); print(10000L) took 3765
constexpr int kSerialRead = 32;
constexpr int kSerialAvailable = 35;

// Tone. M: tone(8, 100), which tries all prescalers and does a long division for each of them.
constexpr int kTone = 4011;
constexpr int kNoTone = 111;

constexpr int kRegister = 2;       ///< lds, sts, sbi: from the instruction set manual
constexpr int kEepromAccess = 20;  ///< eeprom_read_byte of avr-libc, counted in its disassembly
constexpr int kAllocate = 118;     ///< M: malloc(20) on a fresh heap

}  // namespace cost
}  // namespace host
}  // namespace robosim
