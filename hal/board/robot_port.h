// The board as the robot sees it. The robot's parts and the simulation around them call this interface.
#pragma once

#include "hal/board/board.h"

namespace robosim {

/// A signal that the robot puts on a pin. Firmware's reads call it, with a time inside the current tick; it
/// extrapolates from the world's state at the tick's start.
class PinSource {
 public:
  /// The voltage against ground, in volts. May consume a sample of noise.
  virtual double volts(SimTime t) = 0;
  /// The logic level. May consume a sample of noise.
  virtual bool level(SimTime t) = 0;
  /// Until when, exclusive, level() surely is what it is at `t`, however often it is asked, as long as the
  /// pin's drive and the world stay as they are; `t` = it makes no promise.
  virtual SimTime same_until(SimTime t) { return t; }
  /// Its resistance, as the capacitor of an ADC finds it; 0 = so little that it does not count. Constant.
  virtual double source_ohms() const { return 0.0; }

 protected:
  ~PinSource() = default;
};

/// Receives every change in how a pin is driven, in order of time.
class PinWatcher {
 public:
  virtual void pin_changed(Pin pin, const PinDrive& drive, SimTime t) = 0;

 protected:
  ~PinWatcher() = default;
};

/// Receives every byte that the firmware has sent by UART.
class SerialWatcher {
 public:
  /// `t` is when the firmware handed the byte over.
  virtual void byte_sent(uint8_t byte, SimTime t) = 0;

 protected:
  ~SerialWatcher() = default;
};

/// Receives every byte of EEPROM whose writing begins; writing takes kEepromWriteTime.
class EepromWatcher {
 public:
  virtual void eeprom_written(uint16_t address, uint8_t before, uint8_t value, SimTime t) = 0;

 protected:
  ~EepromWatcher() = default;
};

/// Receives every conversion of a pin by an AVR's ADC.
class AdcWatcher {
 public:
  /// The capacitor of the converter was still `volts` away from what the pin has: more than 0 = above.
  virtual void converted(Pin pin, double volts, SimTime t) = 0;

 protected:
  ~AdcWatcher() = default;
};

/// Receives every input of the microcontroller: values that firmware reads from a pin, edges that reach an
/// interrupt, bytes that reach the UART. The order of time holds nearly, but not always.
class InputWatcher {
 public:
  virtual void level_seen(Pin pin, bool level, SimTime t) = 0;
  virtual void volts_seen(Pin pin, double volts, SimTime t) = 0;
  virtual void byte_received(uint8_t byte, SimTime t) = 0;

 protected:
  ~InputWatcher() = default;
};

/// A device on the two-wire bus. Addresses have seven bits.
class TwoWireDevice {
 public:
  /// Whether it answers to `address`, and if so, it is spoken to from now on.
  virtual bool address(uint8_t address, bool reads, SimTime t) = 0;
  /// A byte has come; whether it is acknowledged.
  virtual bool write(uint8_t byte, SimTime t) = 0;
  /// The next byte it sends.
  virtual uint8_t read(SimTime t) = 0;
  /// It is spoken to no longer: a STOP, or the START of something else.
  virtual void stop(SimTime) {}

 protected:
  ~TwoWireDevice() = default;
};

class RobotPort {
 public:
  virtual const BoardSpec& spec() const = 0;
  virtual const PinDrive& drive(Pin pin) const = 0;
  /// One source a pin; the source must outlive the board's use of it.
  virtual void connect(Pin pin, PinSource& source) = 0;
  /// Where several have the same address, the first answers.
  virtual void connect(TwoWireDevice& device) = 0;
  /// From now on the board's supply is this share of the nominal one; it must outlive the board's use of it.
  virtual void feed(const double& /*share*/) {}
  /// Several watchers a pin are told in the order in which they were added.
  virtual void watch(Pin pin, PinWatcher& watcher) = 0;
  virtual void watch_serial(SerialWatcher& watcher) = 0;
  /// Several watchers are told in the order in which they were added.
  virtual void watch_eeprom(EepromWatcher& watcher) = 0;
  /// One watcher; it hears of nothing on boards whose ADC has no such capacitor here.
  virtual void watch_adc(AdcWatcher& /*watcher*/) {}
  /// One watcher at a time; hearing changes nothing.
  virtual void watch_inputs(InputWatcher& watcher) = 0;
  /// `pin` will have `level` from `at` on, a time within the tick that is about to run: this is what
  /// interrupts and polling emulators see. The pin's source must agree with it. Per pin, times must not
  /// decrease. Where the pin has that level already, there is no edge.
  virtual void schedule_edge(Pin pin, bool level, SimTime at) = 0;
  /// Whether an edge on `pin` would be noticed without a read (an interrupt is attached, or a chip's input
  /// register must follow). Sources that are costly to evaluate ask first.
  virtual bool wants_edges(Pin pin) const = 0;
  /// Whether that holds for any pin: asked once a tick.
  virtual bool wants_any_edges() const = 0;
  /// A byte arrives at the UART. Bytes queue at the firmware's baud rate.
  virtual void receive_byte(uint8_t byte, SimTime at) = 0;

 protected:
  ~RobotPort() = default;
};

}  // namespace robosim
