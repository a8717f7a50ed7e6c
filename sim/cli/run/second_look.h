// A second run of a sketch that has failed, now built with the checks of --sanitize: they may name the line
// at fault, such as a product that does not fit a 16-bit int, or an index that overwrote something else long
// before.
#pragma once

#include <optional>
#include <string>

#include "sim/build/sketch.h"
#include "sim/client/runner.h"

namespace robosim::cli {

/// What the first check to fail has found.
struct Finding {
  wire::Crash fault;
  double time_s = 0.0;  ///< simulated, when it was found
  std::string advice;   ///< may be empty
};

template <class V>
void fields(V& v, wire::Same<V, Finding>& f) {
  v("check", f.fault.check, "what was checked: `\"mul_overflow\"`");
  v("reason", f.fault.reason, "a clause");
  fields(v, f.fault.where);
  v("time_s", f.time_s, "when it was found", {.unit = "s"});
}

/// Whether it makes sense: the sketch has failed on an AVR, or crashed on the host, and had no checks.
bool deserves_second_look(const build::Request& sketch, const wire::RunResult& first);

/// Runs no longer than the first run did, of a timeout only the first minute, and a second more where it has
/// crashed: checks take their time. Nothing if no check failed, if the sketch with checks does not compile,
/// or if the user interrupts it. `robot`: whose sketch it is, of several.
std::optional<Finding> look_again(client::Runner& runner, wire::RunRequest request,
                                  const build::Request& sketch, const wire::RunResult& first,
                                  std::size_t robot = 0);

/// Whether detectors have something to tell: the sketch was asked to check itself, or has failed.
bool deserves_detectors(const build::Request& sketch, const wire::RunResult& first);

/// A run of the sketch as it is flashed, without checks: these change its timing, and ask for more RAM and
/// flash than the chip has.
struct AsFlashed {
  std::vector<wire::Detected> detected;
  std::optional<wire::RunResult> crashed;  ///< that run, if it has: whatever the first came to
};
/// Empty if the user interrupts it.
AsFlashed detect_again(client::Runner& runner, wire::RunRequest request, const build::Request& sketch,
                       const wire::RunResult& first);

/// The run's `next`, with the flags that it takes.
std::string next_of(const wire::RunResult& result);
/// What the first run's `next` becomes.
std::string next_after(const wire::RunResult& first, const std::optional<Finding>& finding);

}  // namespace robosim::cli
