// The seam between firmware and robot: what either can see of a microcontroller, and do to it.
//
//   firmware ──► executor ──► FirmwarePort   RobotPort ◄── robot's parts, simulation
//                                       one board
//
// The executor (host, AVR, STM32) speaks for the firmware: it says how each pin is driven, and asks what a
// pin reads, always with the exact time (firmware_port.h). The parts of the robot answer and watch
// (robot_port.h). Neither sees the other's view, and nothing else crosses. No function of either blocks, and
// none looks at the wall clock. Here is what both speak of.
//
// C++14, no standard library: these headers are compiled into firmware images too.
#pragma once

#include <stdint.h>

#include "hal/board/sim_time.h"

namespace robosim {

/// A pin by its Arduino number (`5`, `A0` = 14 on an Uno). See board_spec.h for names.
using Pin = uint8_t;

/// No pin: "not wired".
constexpr Pin kNoPin = 255;

/// Upper bound of Arduino pin numbers over all boards: from here on numbers mean other wires of a robot.
constexpr int kMaxPins = 100;

enum class PinMode : uint8_t { input, input_pullup, output };

/// How the microcontroller drives one pin. All zero is what a reset leaves: input, no pull-up.
struct PinDrive {
  PinMode mode = PinMode::input;
  bool level = false;      ///< output latch; meaningful for `output` without PWM
  bool pwm = false;        ///< a timer drives the pin: `duty` holds, `level` does not
  double duty = 0.0;       ///< fraction of time high, 0..1; equals `level` where `pwm` is false
  uint32_t tone_hz = 0;    ///< square wave by tone(), in Hz; 0 = none
  uint32_t period_us = 0;  ///< of PWM; 0 = not known
};

inline bool operator==(const PinDrive& a, const PinDrive& b) {
  return a.mode == b.mode && a.level == b.level && a.pwm == b.pwm && a.duty == b.duty &&
         a.tone_hz == b.tone_hz && a.period_us == b.period_us;
}
inline bool operator!=(const PinDrive& a, const PinDrive& b) { return !(a == b); }

/// For which a byte of EEPROM is written, old content erased first (datasheet, table 8-1).
constexpr SimTime kEepromWriteTime = 3400 * kMicrosecond;

struct BoardSpec;

}  // namespace robosim
