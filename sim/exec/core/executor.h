// The interface of all executors: they execute the firmware. An executor knows pins and time; it does not
// know robot and world.
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
#include "sim/wire/lateness.h"
#include "sim/wire/run_result.h"

namespace robosim::exec {

namespace gdb {
class Server;
}

using wire::Crash;
using wire::Detected;
using wire::DivisionByZero;
using wire::Lack;
using wire::Lateness;
using wire::Resources;
using wire::SourceLine;

/// The last actions of the firmware, so that a verdict can report what it waits for.
struct Activity {
  SimTime last_call = 0;   ///< when it last called the API (on a chip: accessed I/O outside handlers)
  std::string call;        ///< that call as the sketch would write it: "digitalRead(2)"
  Pin pin = kNoPin;        ///< the pin of that call
  Pin polled = kNoPin;     ///< the pin of its last digitalRead, if that was within the last second
  SourceLine where;        ///< the firmware's present place in the sketch
  std::string stopped_by;  ///< "exit(0)" if the firmware stopped itself; else empty
};

constexpr const char* kCannotBeSaved =
    "saving a run requires an emulated chip: firmware for the host is a program of this machine";

class Executor {
 public:
  virtual ~Executor() = default;

  /// Returns the seam to the robot. Valid for the executor's whole life, across power cycles.
  virtual RobotPort& board() = 0;
  /// Returns access past the seam, for the simulation itself.
  virtual BoardProbe& probe() = 0;

  /// Loads the firmware again and starts it at `t`; all pins are inputs. The EEPROM retains its content.
  virtual void power_on(SimTime t) = 0;
  /// Starts the firmware after a brown-out: the supply fell below the chip's level, but never to zero. A chip
  /// that distinguishes the two reports it to its firmware.
  virtual void power_recovered(SimTime t) { power_on(t); }
  /// Stops the firmware; all pins become inputs without pull-up.
  virtual void power_off(SimTime t) = 0;

  /// Runs the firmware up to simulated time `t`. Edges and bytes scheduled before arrive at their exact time.
  /// Returns at once when the firmware is off or has crashed.
  virtual void run_until(SimTime t) = 0;
  /// Returns the time up to which run_until() would only store the time. That holds unless the board gets an
  /// edge or byte before, or another function of this class is called. 0 = unknown.
  virtual SimTime sleeps_until() const { return 0; }
  /// Does what run_until() does, up to that time.
  virtual void sleep_until(SimTime t) { run_until(t); }

  /// Returns the crash, once the firmware has crashed.
  virtual const std::optional<Crash>& crash() const = 0;
  /// Returns the activity. Costly (reads debug information): for the end of a run.
  virtual Activity activity() = 0;
  /// Returns when the firmware last called the API; cheap.
  virtual SimTime last_call() const = 0;
  /// Returns whether firmware that is silent since then will be silent for ever. That is proved: it loops,
  /// and no possible interrupt can change that. Call it in each tick; the proof is tried only at some of
  /// them.
  virtual bool hangs() { return false; }

  /// Returns the width of the firmware's int in bits.
  virtual int int_bits() const { return 32; }
  /// Returns the resources. Measured on chip targets only, and not for an image that was built with checks.
  virtual std::optional<Resources> resources() const { return std::nullopt; }
  /// Returns the places where firmware has divided by zero since the first power-on; on the host, whose image
  /// reports them.
  virtual const std::vector<DivisionByZero>& divisions_by_zero() const {
    static const std::vector<DivisionByZero> none;
    return none;
  }
  /// Returns the features of the chip that firmware has used since the first power-on, and that this executor
  /// lacks.
  virtual const std::vector<Lack>& lacks() const {
    static const std::vector<Lack> none;
    return none;
  }
  /// Turns on the detectors whose findings detected() returns. Call it before the first power-on. `counted`:
  /// pins of which each edge counts, such as an encoder's.
  virtual void detect(const std::vector<Pin>& counted) { static_cast<void>(counted); }
  virtual std::vector<Detected> detected() const { return {}; }
  /// Counts lines for counters(). Call it before the first power-on. On the host, an image that was built for
  /// coverage counts by itself.
  virtual void count_lines() {}
  /// Returns the counts since the first power-on. On the host there is one file for each power cycle and
  /// source, in gcov's format (.gcda). An image that was not built for coverage has none. On a chip, one file
  /// has lines "LINE COUNT FILE" (exec/elf/line_counts.h).
  virtual std::vector<ArchivedFile> counters() { return {}; }
  /// Returns a copy of all changing state of firmware, chip and board. Throws InputError if that is
  /// impossible.
  virtual std::any save() const { throw InputError(kCannotBeSaved); }
  /// Restores the result of this executor's save(). Watchers of the board are not notified.
  virtual void restore(const std::any& saved) {
    static_cast<void>(saved);
    throw InputError(kCannotBeSaved);
  }
  /// Sets the value with which millis() begins at the next power-on. Throws InputError if that is impossible.
  virtual void set_clock_start(SimTime) {
    throw InputError("setting the clock requires an emulated chip; on the host it is wider and never wraps");
  }
  /// Delays the sketch at these places from the next power-on, as if its code took longer. Sorted by time.
  /// Throws InputError if that is impossible.
  virtual void set_lateness(const std::vector<Lateness>&) {
    throw InputError("delaying a sketch requires the target host");
  }

  /// Returns the firmware's present place in the sketch. Watchers of pins may call it during run_until().
  virtual SourceLine source() { return activity().where; }
  /// Returns the place in the sketch itself if source() is in a library; valid during an instruction or call.
  virtual SourceLine sketch_source() { return source(); }
  /// Returns the current call of the API, as the sketch would write it; empty if its arguments are unknown.
  virtual std::string call_now() const { return ""; }
  /// Prepares source_of() from the next power-on. It is called for every byte that is sent, and answers for
  /// those of this span.
  virtual void trace_bytes(SimTime from, SimTime to) { static_cast<void>(from), static_cast<void>(to); }
  /// Returns the line that printed the byte which is being sent.
  virtual SourceLine source_of(std::uint8_t byte) { return static_cast<void>(byte), source(); }

  /// Prepares driving() from the next power-on. Returns false if lines are unknown, or not known at once.
  virtual bool trace_drives() { return false; }
  /// Returns the line that drives a pin. Call it while the drive is reported. Empty if there is none.
  virtual const SourceLine& driving(Pin pin, const PinDrive& drive) {
    static const SourceLine unknown;
    return static_cast<void>(pin), static_cast<void>(drive), unknown;
  }

  /// Returns an object that finds the causes of what the firmware did. Call it before the first power-on; it
  /// is valid as long as this. Null if causes cannot be found.
  virtual CauseFinder* find_causes() { return nullptr; }

  /// Returns whether the firmware's EEPROM is the board's, so that scripts can corrupt and trace it.
  virtual bool has_boards_eeprom() const { return false; }
  /// Makes the firmware's clock too fast by this number of parts per million, from `t` on, which is now. It
  /// persists through power cycles.
  virtual void set_clock_drift(int ppm, SimTime t) { static_cast<void>(ppm), static_cast<void>(t); }
  /// Lets a debugger halt the firmware from the next power-on; run_until() does not return meanwhile.
  /// `server` must outlive the executor's use. Throws InputError if that is impossible.
  virtual void debug_with(gdb::Server&) {
    throw InputError("attaching a debugger requires an emulated chip");
  }
};

}  // namespace robosim::exec
