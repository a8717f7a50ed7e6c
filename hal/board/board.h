// The interface between firmware and robot: a microcontroller's pins, buses and memory, seen from both sides.
//
//   firmware ──► executor ──► FirmwarePort   RobotPort ◄── robot's parts, simulation
//                                       one board
//
// The executor (host, AVR, STM32) acts for the firmware: it drives pins and reads them, always with the exact
// time (firmware_port.h). The robot's parts provide the values that firmware reads, and observe how firmware
// drives pins (robot_port.h). Each side uses only its own interface, and the two sides have no other
// connection. No function of these interfaces blocks or uses the wall clock. This header defines the types
// that both interfaces share.
//
// These headers use C++14 without the standard library, because firmware images include them, too.
#pragma once

#include <stdint.h>

#include "hal/board/sim_time.h"

namespace robosim {

/// The Arduino number of a pin: 5 for `5`, 14 for `A0` on an Uno. board_spec.h has the names.
using Pin = uint8_t;

/// Marks a pin as not wired.
constexpr Pin kNoPin = 255;

/// An upper bound of the Arduino pin numbers of all boards. Numbers from kMaxPins on denote outputs of the
/// robot's shift registers and PWM drivers (sim/robot/netlist.h).
constexpr int kMaxPins = 100;

enum class PinMode : uint8_t { input, input_pullup, output };

/// Describes how the microcontroller drives one pin. The default is the state after a reset: an input without
/// pull-up.
struct PinDrive {
  /// Returns the drive of an output at a constant level.
  static constexpr PinDrive constant(bool level) {
    return {PinMode::output, level, false, level ? 1.0 : 0.0, 0, 0};
  }

  PinMode mode = PinMode::input;
  bool level = false;      ///< level of the output latch; meaningful only for `output` without PWM
  bool pwm = false;        ///< a timer drives the pin: `duty` is valid, `level` is not
  double duty = 0.0;       ///< share of the time in which the pin is high, 0..1; equals `level` without PWM
  uint32_t tone_hz = 0;    ///< square wave of tone() or of a timer's toggle mode, in Hz; 0 = none
  uint32_t period_us = 0;  ///< period of PWM, in us; 0 = unknown
};

inline bool operator==(const PinDrive& a, const PinDrive& b) {
  return a.mode == b.mode && a.level == b.level && a.pwm == b.pwm && a.duty == b.duty &&
         a.tone_hz == b.tone_hz && a.period_us == b.period_us;
}
inline bool operator!=(const PinDrive& a, const PinDrive& b) { return !(a == b); }

/// The time to erase and write a byte of EEPROM (data sheet of the ATmega328P, table 8-1).
constexpr SimTime kEepromWriteTime = 3400 * kMicrosecond;

/// Why a pin's level is read. `pin`: firmware reads this pin alone. `port`: firmware reads the whole port, or
/// a peripheral reads the pin. Whether firmware uses the level is then unknown.
enum class ReadIntent : uint8_t { pin, port };

/// Describes what is connected to an analog input: a voltage, and the resistance in series with it
/// (Thévenin's equivalent). With 0 Ohm, the source charges the capacitor of an ADC at once.
struct Source {
  constexpr Source(double v = 0.0, double r = 0.0) : volts(v), ohms(r) {}

  double volts;  ///< against ground
  double ohms;
};

struct BoardSpec;

}  // namespace robosim
