#include "sim/cli/run/why_arguments.h"

#include "sim/cli/run_options.h"

namespace robosim::cli {

Command parse_why(const std::vector<std::string>& words) {
  WhyArguments why;
  RunArguments& run = why.run;
  Options options("why", "run a sketch and trace its verdict to the lines that caused it",
                  "Runs the sketch as robosim run does, on the board's AVR.");
  options.positional("[SKETCH]", run.sketch, kSketchHelp, PossibleValues::sketch());
  options.text("--map", run.map, "MAP", kMapHelp, PossibleValues::map());
  options.text("--robot", run.robot, "ROBOT", "use this robot: a file, or the name of a stock robot",
               PossibleValues::robot());
  RunOptions shared(options, run);
  shared.task();
  shared.time();
  shared.seed();
  shared.common();
  options.text("--target", run.target, "TARGET", "trace on this target: avr, the only one (default)",
               PossibleValues::of({"avr"}));
  options.flag("--untrusted", run.untrusted, kUntrustedHelp);
  options.flag("--all", why.all, "print all lines of the chain, not only the ten most direct ones");
  options.flag("--json", run.json, "print the verdict and its chain of causes as JSON");
  if (const auto help = options.parse(words)) return *help;
  shared.finish();
  if (!run.target.empty() && run.target != "avr")
    refuse_value("--target", run.target, "avr, the only target that records each instruction");
  run.target = "avr";
  return why;
}

}  // namespace robosim::cli
