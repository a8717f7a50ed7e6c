// Runs a failed sketch a second time, built with the checks of --sanitize. They may report the line at fault,
// such as a product that does not fit a 16-bit int. Another example is an index that overwrote other data
// long before.
#pragma once

#include <optional>
#include <string>

#include "sim/build/sketch.h"
#include "sim/client/runner.h"

namespace robosim::cli {

/// The finding of the first check that failed.
struct Finding {
  wire::Crash fault;
  double time_s = 0.0;  ///< simulated, of the finding
  std::string advice;   ///< may be empty
};

template <class V>
void fields(V& v, wire::Same<V, Finding>& f) {
  v("check", f.fault.check, "what was checked: `\"mul_overflow\"`");
  v("reason", f.fault.reason, "a clause");
  fields(v, f.fault.where);
  v("time_s", f.time_s, "when it was found", {.unit = "s"});
}

/// Returns whether that makes sense: the sketch has failed on an AVR, or crashed on the host, without checks.
bool deserves_sanitizer_rerun(const build::Request& sketch, const wire::RunResult& first);

/// Runs no longer than the first run did, and for a timeout only the first minute. After a crash it runs a
/// second more: checks take time. Returns nothing if no check failed, if the sketch with checks does not
/// compile, or on interruption by the user. `robot`: the sketch's, of several.
std::optional<Finding> rerun_with_sanitizers(client::Runner& runner, wire::RunRequest request,
                                             const build::Request& sketch, const wire::RunResult& first,
                                             std::size_t robot = 0);

/// Returns whether detectors may report: the sketch was requested to check itself, or has failed.
bool deserves_detectors(const build::Request& sketch, const wire::RunResult& first);

/// A run of the sketch as it is flashed, without checks. These change its timing, and need more RAM and flash
/// than the chip has.
struct AsFlashed {
  std::vector<wire::Detected> detected;
  std::optional<wire::RunResult> crashed;  ///< the repeated run, if it crashed, whatever the first result
};
/// Returns an empty result on interruption by the user.
AsFlashed rerun_with_detectors(client::Runner& runner, wire::RunRequest request, const build::Request& sketch,
                               const wire::RunResult& first);

/// Returns the run's `next`, with the flags that it takes.
std::string next_of(const wire::RunResult& result);
/// Returns the new `next` of the first run.
std::string next_after(const wire::RunResult& first, const std::optional<Finding>& finding);

}  // namespace robosim::cli
