#include "sim/cli/run_options.h"

namespace robosim::cli {

void RunOptions::task() {
  options_.text("--start", run_.request.start, "X,Y,DIR", kStartHelp);
  options_.text("--goal", run_.request.goal, "GOAL", kGoalHelp, goals());
  options_.text("--script", run_.script, "FILE", kScriptHelp, PossibleValues::file());
}

void RunOptions::time() {
  options_.text("--for", texts_.duration, "TIME", "limit the simulated time, as in 60s (default: 10 min)");
  options_.text("--clock", texts_.clock, "TIME",
                "let millis() begin with this time, as in 49.7d (chip targets only)");
}

void RunOptions::seed() {
  options_.text("--seed", texts_.seed, "N", "seed all noise and spread (default: 1)");
}

void RunOptions::common() {
  options_.text("--profile", run_.request.profile, "PROFILE", kProfileHelp, profiles());
  options_.texts("--send", run_.send, "TEXT",
                 "send this text to the sketch's serial port at 1 s; \\n is a new line; may be repeated");
  options_.text("--env", run_.environment, "NAME", kEnvironmentHelp);
  options_.texts("--libraries", run_.libraries, "DIR", kLibrariesHelp, PossibleValues::folder());
}

void RunOptions::finish() { take(texts_, run_); }

}  // namespace robosim::cli
