#include "sim/cli/run/why_arguments.h"

#include "sim/cli/run_options.h"

namespace robosim::cli {

Command parse_why(const std::vector<std::string>& words) {
  WhyArguments why;
  RunArguments& run = why.run;
  Options options(
      "why",
      "Runs a sketch as robosim run does, on its AVR, and follows the verdict back to the lines of "
      "the sketch that caused it.");
  options.positional("SKETCH", run.sketch, "folder, .ino file or name; default: the current folder");
  options.text("--map", run.map, "MAP", "file, or name of a sample map");
  options.text("--robot", run.robot, "ROBOT", "file, or name of a stock robot");
  RunOptions shared(options, run);
  shared.task();
  shared.time();
  shared.seed();
  shared.common();
  options.flag("--json", run.json, "print the verdict and the chain as JSON");
  if (const auto help = options.parse(words)) return PrintText{*help};
  shared.finish();
  run.target = "avr";
  return why;
}

}  // namespace robosim::cli
