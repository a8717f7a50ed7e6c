// The robot's view of the board. The robot's parts and the simulation around them call this interface.
//
// Contract:
//   - While firmware runs, the board calls sources, watchers and devices, in order of time. A time may be
//     earlier than the previous one by at most one instruction.
//   - Inside such a call, sources, watchers and devices may call schedule_edge(), receive_byte(), and all
//     const functions. They must not call connect(), feed() or watch…().
//   - The board does not own sources, watchers and devices. They must exist as long as the firmware runs.
#pragma once

#include "hal/board/board.h"

namespace robosim {

/// A signal that the robot puts on a pin. When firmware reads the pin, the source receives a time inside the
/// current tick. The source extrapolates from the world's state at the tick's start.
class PinSource {
 public:
  /// Returns the logic level. The call may consume a sample of noise.
  virtual bool level(SimTime t) = 0;
  /// Returns the signal as an ADC samples it, while the board's supply is at `supply` volts. The call may
  /// consume a sample of noise. The default is for sources with two levels.
  virtual Source output(SimTime t, double supply) { return level(t) ? supply : 0.0; }
  /// Returns the time before which level() returns the same value as at `t`, for any number of reads. The
  /// guarantee holds while the pin's drive and the world do not change. `t` = no guarantee.
  virtual SimTime same_until(SimTime t) { return t; }

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
  /// Receives a byte; `t` is the time at which the firmware wrote it.
  virtual void byte_sent(uint8_t byte, SimTime t) = 0;

 protected:
  ~SerialWatcher() = default;
};

/// Receives every byte of EEPROM at the beginning of its write. A write takes kEepromWriteTime.
class EepromWatcher {
 public:
  virtual void eeprom_written(uint16_t address, uint8_t before, uint8_t value, SimTime t) = 0;

 protected:
  ~EepromWatcher() = default;
};

/// Receives every input of the microcontroller: values that firmware reads from a pin, edges that reach an
/// interrupt, bytes that reach the UART. The calls are usually, but not always, in order of time.
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
  /// Returns whether the device answers to `address`. A device that answers is selected from now on. `reads`
  /// means that the device shall send.
  virtual bool address(uint8_t address, bool reads, SimTime t) = 0;
  /// Receives a byte, and returns whether the device acknowledges it.
  virtual bool write(uint8_t byte, SimTime t) = 0;
  /// Returns the next byte that the device sends.
  virtual uint8_t read(SimTime t) = 0;
  /// Ends the selection of the device, because of a STOP or the START of another transfer.
  virtual void stop(SimTime) {}

 protected:
  ~TwoWireDevice() = default;
};

class RobotPort {
 public:
  virtual const BoardSpec& spec() const = 0;
  /// Returns how firmware drives `pin`. The reference is valid as long as the board, and follows all changes.
  virtual const PinDrive& drive(Pin pin) const = 0;
  /// Connects a source to `pin`. A pin has at most one source.
  virtual void connect(Pin pin, PinSource& source) = 0;
  /// Connects a device to the two-wire bus. If several devices have the same address, the first one answers.
  virtual void connect(TwoWireDevice& device) = 0;
  /// Connects the board's supply: `volts` is always the present supply voltage. Without a call, the supply is
  /// spec().supply_volts. Must be called before the firmware starts.
  virtual void feed(const double& volts) = 0;
  /// Adds a watcher of a pin's drive. Several watchers of a pin are called in the order in which they were
  /// added.
  virtual void watch(Pin pin, PinWatcher& watcher) = 0;
  virtual void watch_serial(SerialWatcher& watcher) = 0;
  /// Adds a watcher of the EEPROM. Several watchers are called in the order in which they were added.
  virtual void watch_eeprom(EepromWatcher& watcher) = 0;
  /// Sets the only watcher of inputs. The watcher must not influence the run.
  virtual void watch_inputs(InputWatcher& watcher) = 0;
  /// Schedules an edge within the next tick: `pin` has `level` from the time `at` on. The executor receives
  /// the edge if wants_edges() is true for the pin. From `at` on, the pin's source must return `level`. The
  /// times of a pin's edges must not decrease. If the pin already has `level`, the call has no effect.
  virtual void schedule_edge(Pin pin, bool level, SimTime at) = 0;
  /// Returns whether an edge on `pin` has an effect without a read by firmware: an interrupt is attached, or
  /// the input register of an emulated chip must follow the pin. Costly sources call this function first.
  virtual bool wants_edges(Pin pin) const = 0;
  /// Returns whether wants_edges() is true for any pin. The simulation calls this function once a tick.
  virtual bool wants_any_edges() const = 0;
  /// Sends a byte to the UART at the time `at`. Several bytes arrive one after another, at the firmware's
  /// baud rate.
  virtual void receive_byte(uint8_t byte, SimTime at) = 0;

 protected:
  ~RobotPort() = default;
};

}  // namespace robosim
