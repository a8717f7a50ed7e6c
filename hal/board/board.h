// The interface between firmware and robot: a microcontroller's pins, buses and memory, seen from both sides.
//
//   firmware ──► executor ──► FirmwarePort   RobotPort ◄── robot's parts, simulation
//                                       one board
//
// The executor (host, AVR, STM32) acts for the firmware: it drives pins and reads them, always with the exact
// time (firmware_port.h). The robot's parts provide the values and observe changes (robot_port.h). Neither
// side accesses the other's interface, and there is no other connection. No function of either interface
// blocks or uses the wall clock. This header has the types that both interfaces share.
//
// C++14, no standard library: firmware images include these headers, too.
#pragma once

#include <stdint.h>

#include "hal/board/sim_time.h"

namespace robosim {

/// A pin by its Arduino number (`5`, `A0` = 14 on an Uno). board_spec.h has the names.
using Pin = uint8_t;

/// Marks a pin as not wired.
constexpr Pin kNoPin = 255;

/// Upper bound of Arduino pin numbers over all boards. Numbers from here on are a robot's other wires.
constexpr int kMaxPins = 100;

enum class PinMode : uint8_t { input, input_pullup, output };

/// How the microcontroller drives one pin. All zero is the state after a reset: input, no pull-up.
struct PinDrive {
  PinMode mode = PinMode::input;
  bool level = false;      ///< output latch; meaningful for `output` without PWM
  bool pwm = false;        ///< a timer drives the pin: `duty` is valid, `level` is not
  double duty = 0.0;       ///< fraction of time high, 0..1; equals `level` if `pwm` is false
  uint32_t tone_hz = 0;    ///< square wave by tone(), in Hz; 0 = none
  uint32_t period_us = 0;  ///< period of PWM; 0 = unknown
};

inline bool operator==(const PinDrive& a, const PinDrive& b) {
  return a.mode == b.mode && a.level == b.level && a.pwm == b.pwm && a.duty == b.duty &&
         a.tone_hz == b.tone_hz && a.period_us == b.period_us;
}
inline bool operator!=(const PinDrive& a, const PinDrive& b) { return !(a == b); }

/// The time to erase and write a byte of EEPROM (datasheet, table 8-1).
constexpr SimTime kEepromWriteTime = 3400 * kMicrosecond;

struct BoardSpec;

}  // namespace robosim
