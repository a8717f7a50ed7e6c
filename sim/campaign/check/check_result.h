// The results of a sketch's checks, for the reports.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/error.h"
#include "sim/campaign/check/checks_file.h"
#include "sim/wire/messages.h"

namespace robosim::campaign {

struct CheckResult {
  std::string name;
  Place place;
  std::string where;  ///< "oval · uno5 · seeds 1..20"
  ExitStatus status = ExitStatus::interrupted;
  std::string why;     ///< one sentence about a failure
  std::string replay;  ///< the command that repeats the first failed run; empty if no run failed
  /// `again` is `replay` without --sanitize, which `replay` has if a detector found the failure.
  /// `again_trace_hash` is the trace hash of the first failed run.
  std::string again, again_trace_hash;
  std::string serial;  ///< output of the sketch in the first failed run
  std::size_t runs = 0;
  std::size_t passed = 0;
  double time_s = 0.0;                    ///< simulated time, sum of all runs
  std::optional<double> best_lap_s;       ///< the shortest lap of all runs that passed
  std::optional<result::RunResult> only;  ///< the result, if the check has only one run
  std::vector<std::string> traces;        ///< trace hashes of all runs, in the order of the plan

  bool ok() const { return status == ExitStatus::ok; }
};

struct SketchResult {
  std::string name;    ///< for display: as the user named it, or the current folder's name
  std::string checks;  ///< path of the file with the checks
  std::vector<CheckResult> results;
  /// The reason for missing results: a bad file, or a sketch that does not compile.
  struct Problem {
    ExitStatus status = ExitStatus::bad_input;
    Place place;
    std::string line;  ///< the first error, in one line
    std::string text;  ///< the full text
  };
  std::optional<Problem> problem;

  std::size_t passed() const;
  ExitStatus status() const;
};

/// Returns the more important status. From most to least important: interrupted, internal error, missing
/// tool, bad input, failure, timeout.
ExitStatus worse(ExitStatus a, ExitStatus b);

/// Returns why a run does not meet the check, in one sentence; nullopt if the run meets it.
std::optional<std::string> why_failed(const Check& check, const result::RunResult& result);
/// Returns whether `why` is a finding of a detector.
bool is_of_detectors(const std::string& why);

}  // namespace robosim::campaign
