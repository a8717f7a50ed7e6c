// The seam between firmware and robot: what a robot can see of a microcontroller, and do to it.
//
//   firmware ──► executor ──► Board ◄── robot's parts
//
// The executor (host, AVR, STM32) speaks for the firmware: it says how each pin is driven, and asks what a
// pin reads, always with the exact time. The parts of the robot answer (PinSource) and watch (PinWatcher).
// Neither knows the other, and nothing else crosses. No function here blocks, and none looks at the wall
// clock.
//
// C++14, no standard library: this header is compiled into firmware images too.
#pragma once

#include <stdint.h>

#include "hal/board/sim_time.h"

namespace robosim {

/// A pin by its Arduino number (`5`, `A0` = 14 on an Uno). See board_spec.h for names.
using Pin = uint8_t;

/// No pin: "not wired".
constexpr Pin kNoPin = 255;

/// Upper bound of Arduino pin numbers over all boards.
constexpr int kMaxPins = 64;

enum class PinMode : uint8_t { input, input_pullup, output };

/// How the microcontroller drives one pin. All zero is what a reset leaves: input, no pull-up.
struct PinDrive {
  PinMode mode = PinMode::input;
  bool level = false;    ///< output latch; meaningful for `output` without PWM
  bool pwm = false;      ///< a timer drives the pin: `duty` holds, `level` does not
  double duty = 0.0;     ///< fraction of time high, 0..1; equals `level` where `pwm` is false
  uint32_t tone_hz = 0;  ///< square wave by tone(), in Hz; 0 = none
};

inline bool operator==(const PinDrive& a, const PinDrive& b) {
  return a.mode == b.mode && a.level == b.level && a.pwm == b.pwm && a.duty == b.duty &&
         a.tone_hz == b.tone_hz;
}
inline bool operator!=(const PinDrive& a, const PinDrive& b) { return !(a == b); }

/// What the robot puts on a pin. Asked only when firmware looks, with a time inside the current tick; the
/// answer is extrapolated from the world's state at the tick's start.
class PinSource {
 public:
  /// The voltage against ground, in volts. May consume a sample of noise.
  virtual double volts(SimTime t) = 0;
  /// The logic level. May consume a sample of noise.
  virtual bool level(SimTime t) = 0;

 protected:
  ~PinSource() = default;
};

/// Told of every change in the way a pin is driven, in the order of time.
class PinWatcher {
 public:
  virtual void pin_changed(Pin pin, const PinDrive& drive, SimTime t) = 0;

 protected:
  ~PinWatcher() = default;
};

/// Told of every byte that the firmware has sent by UART.
class SerialWatcher {
 public:
  /// `t` is when the firmware handed the byte over.
  virtual void byte_sent(uint8_t byte, SimTime t) = 0;

 protected:
  ~SerialWatcher() = default;
};

/// Told of every byte of EEPROM whose writing begins: it takes kEepromWriteTime.
class EepromWatcher {
 public:
  virtual void eeprom_written(uint16_t address, uint8_t before, uint8_t value, SimTime t) = 0;

 protected:
  ~EepromWatcher() = default;
};

/// For which a byte of EEPROM is written, old content erased first (datasheet, table 8-1).
constexpr SimTime kEepromWriteTime = 3400 * kMicrosecond;

/// Told of what comes into the microcontroller: what its firmware finds when it looks at a pin, edges that
/// reach an interrupt, bytes that reach the UART. Nearly, but not always, in the order of time.
class InputWatcher {
 public:
  virtual void level_seen(Pin pin, bool level, SimTime t) = 0;
  virtual void volts_seen(Pin pin, double volts, SimTime t) = 0;
  virtual void byte_received(uint8_t byte, SimTime t) = 0;

 protected:
  ~InputWatcher() = default;
};

struct BoardSpec;

class Board {
 public:
  virtual ~Board() = default;
  virtual const BoardSpec& spec() const = 0;

  // --- the firmware's side: called by executors
  // -------------------------------------------------------------
  /// The firmware changes how it drives `pin`. Watchers hear of it if it differs from before.
  virtual void set_drive(Pin pin, const PinDrive& drive, SimTime t) = 0;
  /// What a digital read of `pin` gives: its source; an output reads back its own level; an unconnected pin
  /// reads high with a pull-up and low without.
  virtual bool read_level(Pin pin, SimTime t) = 0;
  /// Volts on `pin` at the moment the ADC samples it. Unconnected: as read_level, at 0 V or the supply.
  virtual double read_volts(Pin pin, SimTime t) = 0;
  virtual void send_byte(uint8_t byte, SimTime t) = 0;
  /// Non-volatile memory, of spec().eeprom_bytes; 0xFF when new. Survives power cycles.
  virtual uint8_t* eeprom() = 0;
  /// The firmware begins to write a byte of it; `address` is below spec().eeprom_bytes.
  virtual void write_eeprom(uint16_t address, uint8_t value, SimTime t) = 0;

  // --- the robot's side: called by parts and by the simulation
  // ----------------------------------------------
  virtual const PinDrive& drive(Pin pin) const = 0;
  /// One source a pin; the source must outlive the board's use of it.
  virtual void connect(Pin pin, PinSource& source) = 0;
  /// Several watchers a pin are told in the order in which they were added.
  virtual void watch(Pin pin, PinWatcher& watcher) = 0;
  virtual void watch_serial(SerialWatcher& watcher) = 0;
  /// One watcher at a time.
  virtual void watch_eeprom(EepromWatcher& watcher) = 0;
  /// `pin` will change to `level` at `at`, within the tick that is about to run: this is what interrupts and
  /// polling emulators see. The pin's source must agree with it. Per pin, times must not decrease.
  virtual void schedule_edge(Pin pin, bool level, SimTime at) = 0;
  /// Whether an edge on `pin` would be noticed without a read (an interrupt is attached, or a chip's input
  /// register must follow). Sources that are costly to evaluate ask first.
  virtual bool wants_edges(Pin pin) const = 0;
  /// Whether that holds for any pin: asked once a tick.
  virtual bool wants_any_edges() const = 0;
  /// A byte arrives at the UART. Bytes queue at the firmware's baud rate.
  virtual void receive_byte(uint8_t byte, SimTime at) = 0;
  /// One watcher at a time; hearing changes nothing.
  virtual void watch_inputs(InputWatcher& watcher) = 0;
};

}  // namespace robosim
