// The cost of every Arduino API call on an ATmega328P, in CPU cycles. No other file has these values.
//
// Measured (M): Debian's arduino-core-avr 1.8.7 by gcc-avr 5.4, -Os -flto, run by libsimavr 1.6. A cost is
// the number of cycles between two writes of GPIOR0 around the call, minus that without a call. The calls'
// arguments are not constants.
#pragma once

#include <stdint.h>

#include "hal/board/cycle_time.h"
#include "hal/host/chip.h"

namespace robosim {
namespace host {

constexpr CycleTime kCycles(kClockHz);

/// Returns the nanoseconds of `count` CPU cycles.
constexpr SimTime cycles(int64_t count) { return kCycles.of(count); }

namespace cost {

// The cost of each basic block of the firmware (gcc -O1 on the host). M: cycles in simavr per block on the
// host, in five loops of line followers: 7.9 (three sensors, if-else), 19.2 (shortening a maze's path), 19.3
// (calibration of five sensors), 276 (weighted position with five long divisions), 1421 (PID in floats, one
// block). The value is the median, rounded. It is about right for decisions and loops, but too low for long
// divisions and floats: they take 45 us and 10 us on a chip at 16 MHz.
constexpr int kBlock = 20;
constexpr int kLoop = 10;  ///< from one loop() to the next; M: an empty loop() takes 16 with its own body
constexpr int kInit = 60;  ///< init() in wiring.c, counted in its disassembly

// Digital pins (M)
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
constexpr int kSerialNumber = 130;         ///< print(number): once per call,
constexpr int kSerialDigit = 615;  ///< and per digit, in addition to its write(): print(10000L) took 3765
constexpr int kSerialRead = 32;
constexpr int kSerialAvailable = 35;

// Tone: M for tone(8, 100), which tries all prescalers with a long division each.
constexpr int kTone = 4011;
constexpr int kNoTone = 111;

constexpr int kRegister = 2;       ///< lds, sts, sbi: from the instruction set manual
constexpr int kEepromAccess = 20;  ///< eeprom_read_byte of avr-libc, counted in its disassembly
constexpr int kAllocate = 118;     ///< M: malloc(20) on a fresh heap

}  // namespace cost
}  // namespace host
}  // namespace robosim
