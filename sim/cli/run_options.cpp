#include "sim/cli/run_options.h"

namespace robosim::cli {

void RunOptions::task() {
  options_.text("--start", run_.request.start, "X,Y,DIR", kStartHelp);
  options_.text("--goal", run_.request.goal, "GOAL", kGoalHelp, goals());
  options_.text("--script", run_.script, "FILE", kScriptHelp, PossibleValues::file());
}

void RunOptions::time() {
  options_.text("--for", duration_, "TIME", "limit the simulated time, as in 60s (default: 10 min)");
  options_.text("--clock", clock_, "TIME",
                "let millis() begin with this time, as in 49.7d (chip targets only)");
}

void RunOptions::seed() { options_.text("--seed", seed_, "N", "seed all noise and spread (default: 1)"); }

void RunOptions::common() {
  options_.text("--profile", run_.request.profile, "PROFILE", kProfileHelp, profiles());
  options_.texts("--send", run_.send, "TEXT",
                 "send this text to the sketch's serial port at 1 s; \\n is a new line; may be repeated");
  options_.text("--env", run_.environment, "NAME", kEnvironmentHelp);
  options_.texts("--libraries", run_.libraries, "DIR", kLibrariesHelp, PossibleValues::folder());
}

void RunOptions::finish() {
  if (!duration_.empty()) run_.request.for_ns = simulated_time("--for", duration_);
  if (!clock_.empty()) run_.request.clock_ns = simulated_time("--clock", clock_);
  if (!seed_.empty()) run_.request.seed = seed_number(seed_);
  check_profile(run_.request.profile);
}

}  // namespace robosim::cli
