// Declares the functions that only the executors of some targets have. Executor::chip_access() and
// Executor::host_access() return these interfaces.
#pragma once

#include <any>
#include <optional>
#include <vector>

#include "hal/board/board.h"
#include "hal/board/firmware_action.h"
#include "sim/exec/core/cause_finder.h"
#include "sim/result/lateness.h"
#include "sim/result/run_result.h"

namespace robosim::exec {

namespace gdb {
class Server;
}

/// The interface to firmware that runs in an emulated chip.
class ChipAccess {
 public:
  /// Returns a copy of all changing state of firmware, chip and board.
  virtual std::any save() const = 0;
  /// Restores a state that save() of this executor returned. Watchers of the board are not notified.
  virtual void restore(const std::any& saved) = 0;
  /// Returns the resources used; nullopt for an image built with --sanitize.
  virtual std::optional<result::Resources> resources() const = 0;
  /// Turns on the detectors whose findings detected() returns. Must be called before the first power-on.
  /// `counted` lists the pins on which every edge matters, such as the pins of an encoder.
  virtual void detect(const std::vector<Pin>& counted) = 0;
  virtual std::vector<result::Detected> detected() const = 0;
  /// Sets the value at which millis() starts at the next power-on. Throws InputError if the firmware never
  /// calls millis().
  virtual void set_clock_start(SimTime start) = 0;
  /// Lets a debugger halt the firmware from the next power-on. run_until() does not return while the firmware
  /// is halted. `server` must outlive all use of the executor.
  virtual void debug_with(gdb::Server& server) = 0;
  /// Returns an object that finds the causes of the firmware's actions; null if that is impossible. Must be
  /// called before the first power-on. The object is valid as long as the executor exists.
  virtual CauseFinder* find_causes() = 0;
  /// Enables driving() from the next power-on. Returns false if the executor cannot find the lines, for
  /// example because the image has no debug information.
  virtual bool trace_drives() = 0;
  /// Returns the line that drives a pin; empty if there is no such line. Must be called while the board
  /// reports the pin's change to a PinWatcher.
  virtual const result::SourceLine& driving(Pin pin, const PinDrive& drive) = 0;
  /// Enables source_of() for bytes that are sent from `from` to `to`. Takes effect at the next power-on.
  virtual void trace_bytes(SimTime from, SimTime to) = 0;
  /// Returns the line that printed the byte that is being sent. After trace_bytes(), this function must be
  /// called for every byte that the firmware sends.
  virtual result::SourceLine source_of(std::uint8_t byte) = 0;

 protected:
  ~ChipAccess() = default;
};

/// Receives actions that may be mistakes of the firmware.
class ActionWatcher {
 public:
  /// Receives an action. During this call, Executor::sketch_source() returns the line that acts.
  virtual void acted(const FirmwareAction& action, SimTime t) = 0;

 protected:
  ~ActionWatcher() = default;
};

/// The interface to firmware that is compiled for this computer.
class HostAccess {
 public:
  /// Returns the source lines that have divided by zero since the first power-on.
  virtual const std::vector<result::DivisionByZero>& divisions_by_zero() const = 0;
  /// Returns the chip features that the host lacks, and that firmware has used since the first power-on.
  virtual const std::vector<result::Lack>& lacks() const = 0;
  /// Delays the sketch as `lateness` lists, as if the sketch's code took longer. The times in the list must
  /// be in ascending order. Takes effect at the next power-on.
  virtual void set_lateness(const std::vector<result::Lateness>& lateness) = 0;
  /// Sets the only watcher of actions that may be mistakes. The watcher must not influence the run.
  virtual void watch_actions(ActionWatcher& watcher) = 0;

 protected:
  ~HostAccess() = default;
};

}  // namespace robosim::exec
