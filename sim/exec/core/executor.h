// The interface of all executors. An executor runs the firmware. It depends on pins and time only, not on
// robot and world.
#pragma once

#include <any>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hal/board/robot_port.h"
#include "sim/base/archive.h"
#include "sim/base/error.h"
#include "sim/exec/core/board_probe.h"
#include "sim/exec/core/cause_finder.h"
#include "sim/exec/core/detector.h"
#include "sim/result/lateness.h"
#include "sim/result/run_result.h"

namespace robosim::exec {

namespace gdb {
class Server;
}

using result::Crash;
using result::Detected;
using result::DivisionByZero;
using result::Lack;
using result::Lateness;
using result::Resources;
using result::SourceLine;

/// The last actions of the firmware, so that a verdict can name what the firmware waits for.
struct Activity {
  SimTime last_call = 0;   ///< time of the last API call (on a chip: of the last I/O outside handlers)
  std::string call;        ///< the call as the sketch would write it: "digitalRead(2)"
  Pin pin = kNoPin;        ///< pin of the call
  Pin polled = kNoPin;     ///< pin of the last digitalRead() if that was within the last second
  SourceLine where;        ///< present place in the sketch
  std::string stopped_by;  ///< "exit(0)" if the firmware stopped itself; else empty
};

constexpr const char* kCannotBeSaved =
    "saving a run requires an emulated chip: firmware for the host is a program of this machine";

class Executor {
 public:
  virtual ~Executor() = default;

  /// Returns the interface to the robot. It is valid for the executor's whole life, across power cycles.
  virtual RobotPort& board() = 0;
  /// Returns the simulation's direct access to the board.
  virtual BoardProbe& probe() = 0;

  /// Loads the firmware again and starts it at `t`; all pins are inputs. The EEPROM retains its content.
  virtual void power_on(SimTime t) = 0;
  /// Starts the firmware after a brown-out: the supply fell below the chip's minimum, but never to zero. A
  /// chip that distinguishes brown-out and power-on reports the difference to its firmware.
  virtual void power_recovered(SimTime t) { power_on(t); }
  /// Stops the firmware; all pins become inputs without pull-up.
  virtual void power_off(SimTime t) = 0;

  /// Runs the firmware up to simulated time `t`. Edges and bytes scheduled before `t` arrive at their exact
  /// time. Returns at once if the firmware is off or has crashed.
  virtual void run_until(SimTime t) = 0;
  /// Returns the time up to which run_until() has no effect except on the time; 0 = unknown. The result is
  /// valid until the board gets an edge or byte, or another function of this class is called.
  virtual SimTime sleeps_until() const { return 0; }
  /// Variant of run_until() for times up to sleeps_until().
  virtual void sleep_until(SimTime t) { run_until(t); }

  /// Returns the crash; empty if the firmware has not crashed.
  virtual const std::optional<Crash>& crash() const = 0;
  /// Returns the activity. Reads debug information, which is costly: call it at the end of a run.
  virtual Activity activity() = 0;
  /// Returns when the firmware last called the API. Cheap.
  virtual SimTime last_call() const = 0;
  /// Returns whether the firmware has been proved to stay silent for ever: it loops, and no possible
  /// interrupt can change that. Call it in each tick; the proof is attempted only in some ticks.
  virtual bool hangs() { return false; }

  /// Returns the width of the firmware's int in bits.
  virtual int int_bits() const { return 32; }
  /// Returns the resources used. They are measured on chip targets only, and not for an image built with
  /// checks.
  virtual std::optional<Resources> resources() const { return std::nullopt; }
  /// Returns the places where firmware has divided by zero since the first power-on. Only images for the host
  /// report them.
  virtual const std::vector<DivisionByZero>& divisions_by_zero() const {
    static const std::vector<DivisionByZero> none;
    return none;
  }
  /// Returns the chip features that firmware has used since the first power-on, but that this executor lacks.
  virtual const std::vector<Lack>& lacks() const {
    static const std::vector<Lack> none;
    return none;
  }
  /// Turns on the detectors whose findings detected() returns. Call it before the first power-on. `counted`:
  /// pins on which every edge matters, such as an encoder's.
  virtual void detect(const std::vector<Pin>& counted) { static_cast<void>(counted); }
  virtual std::vector<Detected> detected() const { return {}; }
  /// Counts lines for counters(). Call it before the first power-on. On the host, an image built for coverage
  /// always counts.
  virtual void count_lines() {}
  /// Returns the counts since the first power-on. On the host, an image built for coverage has one file in
  /// gcov's format (.gcda) for each power cycle and source; other images have none. On a chip, one file has
  /// lines "LINE COUNT FILE" (exec/elf/line_counts.h).
  virtual std::vector<ArchivedFile> counters() { return {}; }
  /// Returns a copy of all changing state of firmware, chip and board. Throws InputError if that is
  /// impossible.
  virtual std::any save() const { throw InputError(kCannotBeSaved); }
  /// Restores a state that this executor's save() returned. Watchers of the board are not notified.
  virtual void restore(const std::any& saved) {
    static_cast<void>(saved);
    throw InputError(kCannotBeSaved);
  }
  /// Sets the value at which millis() starts at the next power-on. Throws InputError if that is impossible.
  virtual void set_clock_start(SimTime) {
    throw InputError(
        "setting the clock requires an emulated chip; on the host, millis() is wider and never wraps");
  }
  /// Delays the sketch at these times, in ascending order, as if its code took longer. Takes effect at the
  /// next power-on. Throws InputError if that is impossible.
  virtual void set_lateness(const std::vector<Lateness>&) {
    throw InputError("delaying a sketch requires the target host");
  }

  /// Returns the firmware's present place in the sketch. Watchers of pins may call it during run_until().
  virtual SourceLine source() { return activity().where; }
  /// Returns the place in the sketch itself if source() is in a library. Call it during an instruction or
  /// call.
  virtual SourceLine sketch_source() { return source(); }
  /// Returns the current call of the API as the sketch would write it; empty if its arguments are unknown.
  virtual std::string call_now() const { return ""; }
  /// Prepares source_of() for bytes that are sent in this time span. Takes effect at the next power-on.
  virtual void trace_bytes(SimTime from, SimTime to) { static_cast<void>(from), static_cast<void>(to); }
  /// Returns the line that printed the byte that is being sent. After trace_bytes(), call it for every byte.
  virtual SourceLine source_of(std::uint8_t byte) { return static_cast<void>(byte), source(); }

  /// Prepares driving(). Takes effect at the next power-on. Returns false if lines are unknown, or are not
  /// known while the drive is reported.
  virtual bool trace_drives() { return false; }
  /// Returns the line that drives a pin; empty without one. Call it while the drive is reported.
  virtual const SourceLine& driving(Pin pin, const PinDrive& drive) {
    static const SourceLine unknown;
    return static_cast<void>(pin), static_cast<void>(drive), unknown;
  }

  /// Returns an object that finds the causes of firmware's actions; null if that is impossible. Call it
  /// before the first power-on. The object is valid as long as this executor.
  virtual CauseFinder* find_causes() { return nullptr; }

  /// Returns whether the firmware uses the board's EEPROM, so that scripts can corrupt and trace it.
  virtual bool has_boards_eeprom() const { return false; }
  /// Makes the firmware's clock too fast by `ppm` parts per million from `t` on, which must be now. The drift
  /// persists through power cycles.
  virtual void set_clock_drift(int ppm, SimTime t) { static_cast<void>(ppm), static_cast<void>(t); }
  /// Lets a debugger halt the firmware, starting at the next power-on. run_until() does not return while the
  /// firmware is halted. `server` must outlive the executor's use. Throws InputError if debugging is
  /// impossible.
  virtual void debug_with(gdb::Server&) {
    throw InputError("attaching a debugger requires an emulated chip");
  }
};

}  // namespace robosim::exec
