// The interface of all executors. An executor runs the firmware. It knows only pins and time, and nothing
// about the robot and the world.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hal/board/robot_port.h"
#include "sim/base/archive.h"
#include "sim/base/error.h"
#include "sim/exec/core/board_probe.h"
#include "sim/exec/core/target_access.h"
#include "sim/result/run_result.h"

namespace robosim::exec {

using result::Crash;
using result::Detected;
using result::DivisionByZero;
using result::Lack;
using result::Lateness;
using result::Resources;
using result::SourceLine;

/// The last actions of the firmware, so that a verdict can name what the firmware waits for.
struct Activity {
  SimTime last_call = 0;   ///< time of the last API call; on a chip, of the last I/O outside handlers
  std::string call;        ///< the call as the sketch would write it: "digitalRead(2)"
  Pin pin = kNoPin;        ///< pin of the call
  Pin polled = kNoPin;     ///< only pin that was read recently; kNoPin if the last read was over 1 s ago
  SourceLine where;        ///< source line that is running
  std::string stopped_by;  ///< "exit(0)" if the firmware stopped itself; else empty
};

class Executor {
 public:
  virtual ~Executor() = default;

  /// Returns the interface to the robot. The reference is valid during the executor's whole life, even across
  /// power cycles.
  virtual RobotPort& board() = 0;
  /// Returns the simulation's direct access to the board.
  virtual BoardProbe& probe() = 0;

  /// Loads the firmware again and starts it at `t`; all pins are inputs. The EEPROM retains its content.
  virtual void power_on(SimTime t) = 0;
  /// Starts the firmware after a brown-out: the supply fell below the chip's minimum, but never to zero. A
  /// chip that distinguishes a brown-out from a power-on reports the difference to its firmware.
  virtual void power_recovered(SimTime t) { power_on(t); }
  /// Stops the firmware; all pins become inputs without pull-up.
  virtual void power_off(SimTime t) = 0;

  /// Runs the firmware up to simulated time `t`. Edges and bytes scheduled before `t` arrive at their exact
  /// time. Returns at once if the firmware is off or has crashed.
  virtual void run_until(SimTime t) = 0;
  /// Returns the time up to which run_until() would only advance the time; 0 = unknown. The result is valid
  /// until the board gets an edge or byte, or another function of this class is called.
  virtual SimTime sleeps_until() const { return 0; }
  /// Faster variant of run_until() for times up to sleeps_until().
  virtual void sleep_until(SimTime t) { run_until(t); }

  /// Returns the crash; empty if the firmware has not crashed.
  virtual const std::optional<Crash>& crash() const = 0;
  /// Returns the firmware's activity. The call is slow, because it reads debug information. Therefore it
  /// should be called only at the end of a run.
  virtual Activity activity() = 0;
  /// Returns when the firmware last called the API. The call is fast.
  virtual SimTime last_call() const = 0;
  /// Returns whether the firmware will never call the API again, because it runs a loop that no interrupt can
  /// end. On an STM32, `true` is a guess, not a proof. Must be called in each tick, although the call checks
  /// the loop only in some ticks.
  virtual bool hangs() { return false; }

  /// Returns the width of the firmware's int in bits.
  virtual int int_bits() const { return 32; }
  /// Makes the firmware count source lines for counters(). Must be called before the first power-on. On the
  /// host, this call has no effect: an image built for coverage always counts, and other images never count.
  virtual void count_lines() {}
  /// Returns the counts since the first power-on. On the host, an image built for coverage has one file in
  /// gcov's format (.gcda) for each power cycle and source file; other images have none. On a chip, one file
  /// has lines "LINE COUNT FILE" (exec/elf/line_counts.h).
  virtual std::vector<ArchivedFile> counters() { return {}; }
  /// Returns the source line that is running. Watchers of pins may call this function during run_until().
  virtual SourceLine source() { return activity().where; }
  /// Returns the line of the sketch itself. If source() is in a library, this is the line that called the
  /// library. Must be called while an instruction or a call of the API runs.
  virtual SourceLine sketch_source() { return source(); }
  /// Returns the current call of the API as the sketch would write it: "digitalRead(2)". Returns an empty
  /// text if the arguments are unknown.
  virtual std::string call_now() const { return ""; }
  /// Returns how often the watchdog has reset the firmware since the beginning of the run.
  virtual int watchdog_resets() const { return 0; }
  /// Returns whether the firmware uses the board's EEPROM. If so, scripts can corrupt and trace the EEPROM.
  virtual bool has_boards_eeprom() const { return false; }
  /// Makes the firmware's clock too fast by `ppm` parts per million from `t` on. `t` must be the present
  /// time. The drift persists through power cycles.
  virtual void set_clock_drift(int ppm, SimTime t) { static_cast<void>(ppm), static_cast<void>(t); }

  /// Returns the additional functions of an executor with an emulated chip; null on the host.
  virtual ChipAccess* chip_access() { return nullptr; }
  /// Returns the additional functions of an executor on the host; null on a chip.
  virtual HostAccess* host_access() { return nullptr; }
};

/// Returns executor.chip_access(). On the host, throws InputError with the text `otherwise`.
inline ChipAccess& chip_of(Executor& executor, const char* otherwise) {
  if (ChipAccess* const chip = executor.chip_access()) return *chip;
  throw InputError(otherwise);
}

}  // namespace robosim::exec
