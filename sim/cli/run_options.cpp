#include "sim/cli/run_options.h"

namespace robosim::cli {

void RunOptions::task() {
  options_.text("--start", run_.request.start, "X,Y,DIR",
                "start cell (column, row) and heading: N, S, E or W");
  options_.text("--goal", run_.request.goal, "GOAL",
                "tour, laps:N, station:N, still, none, or a competition's (docs/reference/courses.md)");
  options_.text("--script", run_.script, "FILE", "what happens meanwhile: buttons, serial, faults");
}

void RunOptions::time() {
  options_.text("--for", duration_, "TIME", "simulated time at most, as in 60s; default: 10 min");
  options_.text("--clock", clock_, "TIME", "what millis() begins with, as in 49.7d; on a chip target");
}

void RunOptions::seed() { options_.text("--seed", seed_, "N", "of all noise and spread; default: 1"); }

void RunOptions::common() {
  options_.text("--profile", run_.request.profile, "PROFILE", kProfiles);
  options_.texts("--send", run_.send, "TEXT", "sent to the sketch's serial port at 1 s; \\n is a new line");
  options_.text("--env", run_.environment, "NAME", kEnvironment);
  options_.texts("--libraries", run_.libraries, "DIR", "a folder of Arduino libraries; may be repeated");
}

void RunOptions::finish() {
  if (!duration_.empty()) run_.request.for_ns = simulated_time("--for", duration_);
  if (!clock_.empty()) run_.request.clock_ns = simulated_time("--clock", clock_);
  if (!seed_.empty()) run_.request.seed = seed_number(seed_);
  check_profile(run_.request.profile);
}

}  // namespace robosim::cli
