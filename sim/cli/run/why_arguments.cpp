#include "sim/cli/run/why_arguments.h"

#include "sim/cli/options.h"

namespace robosim::cli {

Command parse_why(const std::vector<std::string>& words) {
  WhyArguments why;
  RunArguments& run = why.run;
  std::string duration, clock, number;
  Options options(
      "why",
      "Runs a sketch as robosim run does, on its AVR, and follows the verdict back to the lines of "
      "the sketch that caused it.");
  options.positional("SKETCH", run.sketch, "folder, .ino file or name; default: the current folder");
  options.text("--map", run.map, "MAP", "file, or name of a sample map");
  options.text("--robot", run.robot, "ROBOT", "file, or name of a stock robot");
  options.text("--start", run.request.start, "X,Y,DIR", "start cell (column, row) and heading: N, S, E or W");
  options.text("--goal", run.request.goal, "GOAL",
               "tour, laps:N, station:N, still, none, or a competition's (docs/courses.md)");
  options.text("--for", duration, "TIME", "simulated time at most, as in 60s; default: 10 min");
  options.text("--clock", clock, "TIME", "what millis() begins with, as in 49.7d");
  options.text("--seed", number, "N", "of all noise and spread; default: 1");
  options.text("--profile", run.request.profile, "PROFILE", kProfiles);
  options.text("--script", run.script, "FILE", "what happens meanwhile: buttons, serial, faults");
  options.texts("--send", run.send, "TEXT", "sent to the sketch's serial port at 1 s; \\n is a new line");
  options.text("--env", run.environment, "NAME", kEnvironment);
  options.texts("--libraries", run.libraries, "DIR", "a folder of Arduino libraries; may be repeated");
  options.flag("--json", run.json, "print the verdict and the chain as JSON");
  if (const auto help = options.parse(words)) return PrintText{*help};
  if (!duration.empty()) run.request.for_ns = simulated_time("--for", duration);
  if (!clock.empty()) run.request.clock_ns = simulated_time("--clock", clock);
  if (!number.empty()) run.request.seed = seed_number(number);
  check_profile(run.request.profile);
  run.target = "avr";
  return why;
}

}  // namespace robosim::cli
