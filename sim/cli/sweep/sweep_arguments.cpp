#include "sim/cli/sweep/sweep_arguments.h"

#include "sim/base/error.h"
#include "sim/cli/run_options.h"

namespace robosim::cli {

Command parse_sweep(const std::vector<std::string>& words) {
  SweepArguments sweep;
  campaign::SweepTexts texts;
  Options options(
      "sweep", "run many seeds, maps, robots and targets and count the successes",
      "Runs each sketch on each map with each robot on each target, with all seeds. The result is "
      "the same for any number of jobs.");
  options.positionals("[SKETCH]", sweep.sketches,
                      "run these sketches: folders, .ino files or names of sample sketches, before the "
                      "options (default: the current folder)",
                      PossibleValues::sketch());
  options.lists("--map", sweep.maps, "MAP", "use these maps: files, or names of sample maps",
                PossibleValues::map());
  options.lists("--robot", sweep.robots, "ROBOT", "use these robots: files, or names of stock robots",
                PossibleValues::robot());
  options.lists("--target", sweep.targets, "TARGET", "execute on these targets: host, avr, stm32", targets());
  options.text("--seeds", texts.seeds, "A..B", "run from the first to the last seed (default: 1..100)");
  options.text("--jobs", texts.jobs, "N", kJobsHelp);
  options.text("--csv", sweep.csv, "FILE", "write a row for each run to this file", PossibleValues::file());
  options.flag("--resume", sweep.resume, "continue the table of --csv; skip its finished runs");
  options.text("--shard", texts.shard, "I/N", kShardHelp);
  options.lists("--merge", sweep.merge, "FILE",
                "take the runs of these tables of --shard instead of doing them again",
                PossibleValues::file());
  options.text("--min-rate", texts.min_rate, "R",
               "exit with status 1 if less than this share of the runs reaches the goal");
  options.flag("--sure", sweep.sure, "demand that the runs prove --min-rate in general, at 95 % confidence");
  options.flag("--stop-early", sweep.stop_early, "skip runs that cannot change whether --min-rate is met");
  options.flag("--json", sweep.json, "print a line of JSON for each run");
  RunOptions shared(options, sweep.each);
  shared.task();
  shared.time();
  shared.common();
  options.flag("--sanitize", sweep.each.sanitize,
               "stop at the first bad index, overflow, wild pointer ... (host only)");
  options.flag("--untrusted", sweep.each.untrusted, kUntrustedHelp);
  if (const auto help = options.parse(words)) return *help;
  shared.finish();
  take(texts, sweep);
  if (!sweep.merge.empty() && sweep.json)
    throw InputError("--merge does not repeat the runs of its tables, so --json would lack them");
  if (sweep.resume && sweep.json)
    throw InputError("--resume does not repeat the runs of the --csv file, so --json would lack them");
  return sweep;
}

}  // namespace robosim::cli
