// Who executes the firmware. An executor knows pins and time; it knows no robot and no world.
#pragma once

#include <any>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hal/board/robot_port.h"
#include "sim/base/bundle.h"
#include "sim/base/error.h"
#include "sim/exec/core/board_probe.h"
#include "sim/exec/core/causes.h"
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

/// What the firmware did last, so that a verdict can say what it waits for.
struct Activity {
  SimTime last_call = 0;   ///< when it last called the API (on a chip: accessed I/O outside handlers)
  std::string call;        ///< that call as the sketch would write it: "digitalRead(2)"
  Pin pin = kNoPin;        ///< the pin of that call
  Pin polled = kNoPin;     ///< the pin of its last digitalRead, if that was within the last second
  SourceLine where;        ///< where in the sketch the firmware is now
  std::string stopped_by;  ///< "exit(0)" if the firmware gave up by itself; else empty
};

constexpr const char* kCannotBeSaved =
    "only a run on an emulated chip can be saved: firmware for the host is a program of this machine";

class Executor {
 public:
  virtual ~Executor() = default;

  /// The seam to the robot. Valid for the executor's whole life, across power cycles.
  virtual RobotPort& board() = 0;
  /// Past the seam, for the simulation itself.
  virtual BoardProbe& probe() = 0;

  /// Loads the firmware afresh and starts it at `t`; all pins are inputs. EEPROM keeps its content.
  virtual void power_on(SimTime t) = 0;
  /// The same behind a brown-out: the supply had sunk below the chip's level, but was never gone. A chip that
  /// tells the two apart says so to its firmware.
  virtual void power_recovered(SimTime t) { power_on(t); }
  /// Stops the firmware; all pins become inputs without pull-up.
  virtual void power_off(SimTime t) = 0;

  /// Runs the firmware up to simulated time `t`. Edges and bytes scheduled before arrive at their exact time.
  /// Returns at once when the firmware is off or has crashed.
  virtual void run_until(SimTime t) = 0;
  /// Up to when run_until() would do nothing but note the time, unless the board gets an edge or byte
  /// meanwhile, or anybody calls anything else here. 0 = that is not known.
  virtual SimTime sleeps_until() const { return 0; }
  /// run_until(), up to that time.
  virtual void sleep_until(SimTime t) { run_until(t); }

  /// Set once the firmware has crashed.
  virtual const std::optional<Crash>& crash() const = 0;
  /// Costly (reads debug information): for the end of a run.
  virtual Activity activity() = 0;
  /// When the firmware last called the API; cheap.
  virtual SimTime last_call() const = 0;
  /// Whether firmware that is silent since then will be silent for ever. That is proved: it goes round, and
  /// no interrupt that may come can change that. To be asked in each tick; the proof is tried now and then.
  virtual bool hangs() { return false; }

  /// How wide the firmware's int is.
  virtual int int_bits() const { return 32; }
  /// Measured on chip targets only, and not of an image that was built with checks.
  virtual std::optional<Resources> resources() const { return std::nullopt; }
  /// Where firmware has divided by zero since the first power-on; on the host, whose image tells.
  virtual const std::vector<DivisionByZero>& divisions_by_zero() const {
    static const std::vector<DivisionByZero> none;
    return none;
  }
  /// What firmware has used of the chip that this executor lacks, since the first power-on.
  virtual const std::vector<Lack>& lacks() const {
    static const std::vector<Lack> none;
    return none;
  }
  /// Before the first power-on: detected() shall tell what detectors see in firmware and chip. `counted`:
  /// pins each edge of which counts, as an encoder's does.
  virtual void detect(const std::vector<Pin>& counted) { static_cast<void>(counted); }
  virtual std::vector<Detected> detected() const { return {}; }
  /// Before the first power-on: counters() shall tell which lines ran. On the host an image that was built
  /// for coverage counts by itself.
  virtual void count_lines() {}
  /// What has been counted since the first power-on. On the host of each power cycle and each source a file
  /// as gcov reads it (.gcda), and nothing of an image that was not built for coverage; on a chip one file
  /// with lines "LINE COUNT FILE" (exec/elf/line_counts.h).
  virtual std::vector<BundledFile> counters() { return {}; }
  /// A copy of all that changes in firmware, chip and board. Throws InputError where that cannot be.
  virtual std::any save() const { throw InputError(kCannotBeSaved); }
  /// What this executor's save() gave. Nobody who watches the board is told.
  virtual void restore(const std::any& saved) {
    static_cast<void>(saved);
    throw InputError(kCannotBeSaved);
  }
  /// What millis() shall begin with at the next power-on. Throws InputError where that cannot be.
  virtual void set_clock_start(SimTime) {
    throw InputError(
        "the clock can be set on an emulated chip only; on the host it is wider and never wraps");
  }
  /// From the next power-on the sketch is late there, as if its code took so much longer. In the order of
  /// their times. Throws InputError where that cannot be.
  virtual void set_lateness(const std::vector<Lateness>&) {
    throw InputError("a sketch can be made late on the host only");
  }

  /// Where in the sketch the firmware is now; also while run_until() lasts, for watchers of pins.
  virtual SourceLine source() { return activity().where; }
  /// The same, of the sketch itself where it is in a library; while an instruction or call is going on.
  virtual SourceLine sketch_source() { return source(); }
  /// The call of the API that is going on, as the sketch would write it; empty where its arguments are
  /// unknown.
  virtual std::string call_now() const { return ""; }
  /// From the next power-on, source_of() is asked for every byte that is sent, and answers for those of this
  /// span.
  virtual void trace_bytes(SimTime from, SimTime to) { static_cast<void>(from), static_cast<void>(to); }
  /// The line that has printed the byte which is being sent.
  virtual SourceLine source_of(std::uint8_t byte) { return static_cast<void>(byte), source(); }

  /// From the next power-on, driving() tells lines. False if it cannot: it knows none, or not at once.
  virtual bool trace_drives() { return false; }
  /// The line that drives a pin, to be asked while that is told; empty where none has.
  virtual const SourceLine& driving(Pin pin, const PinDrive& drive) {
    static const SourceLine unknown;
    return static_cast<void>(pin), static_cast<void>(drive), unknown;
  }

  /// Before the first power-on: who can tell why the firmware did what it did, as long as this is there.
  /// Null where nobody can.
  virtual CauseFinder* find_causes() { return nullptr; }

  /// Whether the firmware's EEPROM is the board's, so that scripts can break and follow it.
  virtual bool has_boards_eeprom() const { return false; }
  /// From `t` on, which is now, the firmware's clock runs so much too fast, in parts per million; also after
  /// a power cycle.
  virtual void set_clock_drift(int ppm, SimTime t) { static_cast<void>(ppm), static_cast<void>(t); }
  /// From the next power-on, a debugger may halt the firmware: run_until() then does not return. `server`
  /// must outlive the executor's use. Throws InputError where that cannot be.
  virtual void debug_with(gdb::Server&) { throw InputError("a debugger attaches to an emulated chip only"); }
};

}  // namespace robosim::exec
