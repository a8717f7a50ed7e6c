// The options of a run that several commands share. Each command adds the groups that it supports.
#pragma once

#include "sim/cli/options.h"
#include "sim/launch/run_settings.h"

namespace robosim::cli {

// Explanations of options that may also be given for one of several robots.
constexpr const char* kStartHelp = "start in this cell (column, row) with the heading N, S, E or W";
constexpr const char* kGoalHelp =
    "pursue this goal: tour, laps:N, station:NAME, still, none, or a competition's "
    "(docs/reference/courses.md)";
constexpr const char* kScriptHelp = "apply this script during the run: buttons, serial text, faults";

class RunOptions {
 public:
  /// Both arguments must outlive this object.
  RunOptions(Options& options, launch::RunSettings& run) : options_(options), run_(run) {}
  RunOptions(const RunOptions&) = delete;
  RunOptions& operator=(const RunOptions&) = delete;

  void task();    ///< --start, --goal, --script
  void time();    ///< --for, --clock
  void seed();    ///< --seed
  void common();  ///< --profile, --send, --env, --libraries: for every command that runs sketches

  /// Stores the given values in the run. Call it after the options are parsed. Throws InputError.
  void finish();

 private:
  Options& options_;
  launch::RunSettings& run_;
  launch::RunTexts texts_;
};

}  // namespace robosim::cli
