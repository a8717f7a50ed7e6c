// Runs a failed sketch a second time, built with the checks of --sanitize. The checks may report the faulty
// line. Examples are a product that does not fit a 16-bit int, and an index that has overwritten other data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/build/sketch.h"
#include "sim/launch/client/runner.h"
#include "sim/result/run_result.h"

namespace robosim::campaign {

/// Returns whether a second run with checks is useful. This is the case if a sketch without checks has failed
/// on an AVR, or crashed on the host.
bool deserves_sanitizer_rerun(const build::Request& sketch, const result::RunResult& first);

/// The result of a run with checks.
struct Checked {
  std::optional<result::Finding> finding;  ///< the first failed check
  /// No check failed in the whole run. If neither this nor `finding` is set, nothing is known: the sketch
  /// does not compile with checks, crashed for another reason, or the user interrupted the run.
  bool is_clean = false;
  std::vector<std::string> unset = {};  ///< messages of the build, as in unset_variables()
};

/// Repeats the run with checks, at most as long as the first run. After a timeout, runs at most one minute.
/// After a crash, runs one second longer, because checks take time. `robot` is the number of the sketch's
/// robot, if there are several.
Checked rerun_with_sanitizers(client::Runner& runner, wire::RunRequest request, const build::Request& sketch,
                              const result::RunResult& first, std::size_t robot = 0);

/// Returns messages about variables that may be used before they have a value: "My.ino:9:3: 'sum' may be …".
/// Only a build with checks gives them. Returns an empty list unless a sketch without checks has failed.
std::vector<std::string> unset_variables(const build::Request& sketch, const result::RunResult& first);
/// Returns the first of these messages (`unset`), followed by the hint `next`.
std::string after_unset(const std::vector<std::string>& unset, const std::string& next);

/// Returns whether detectors may report: the user requested checks, or the sketch has failed.
bool deserves_detectors(const build::Request& sketch, const result::RunResult& first);

/// A run of the sketch as flashed, without checks. Checks change the timing, and need more RAM and flash than
/// the chip has.
struct AsFlashed {
  std::vector<result::Detected> detected;
  std::optional<result::RunResult> crashed;  ///< the repeated run, if it crashed and the first run had checks
};
/// Runs the sketch as flashed, with detectors. Returns an empty result if the user interrupts the run.
AsFlashed rerun_with_detectors(client::Runner& runner, wire::RunRequest request, const build::Request& sketch,
                               const result::RunResult& first);

/// Returns the hint `next` of the run's result, with the flags that the user needs.
std::string next_of(const result::RunResult& result);
/// Returns the hint `next` of the first run, updated by the second run's result.
std::string next_after(const result::RunResult& first, const Checked& second);

}  // namespace robosim::campaign
