#include "sim/cli/compare/compare_arguments.h"

#include <algorithm>

#include "sim/base/error.h"
#include "sim/cli/run_options.h"
#include "sim/cli/sweep/sweep_arguments.h"
#include "sim/launch/fleet.h"

namespace robosim::cli {

Command parse_compare(const std::vector<std::string>& words) {
  CompareArguments compare;
  std::string seed, seeds;
  Options options("compare",
                  "Runs a sketch on several targets side by side, and finds the first thing that they do "
                  "differently.");
  options.positional("SKETCH", compare.sketch, "folder, .ino file or name; default: the current folder");
  options.text("--map", compare.map, "MAP", "file, or name of a sample map");
  options.text("--robot", compare.robot, "ROBOT",
               "file, or name of a stock robot; each target puts a board of its own on it");
  options.lists("--target", compare.targets, "TARGET...", "two or more; default: host,avr,stm32");
  options.text("--seed", seed, "N", "of all noise and spread; default: 1");
  options.text("--seeds", seeds, "A..B", "one after the other, until they differ");
  RunOptions shared(options, compare.each);
  shared.task();
  shared.time();
  shared.common();
  options.flag("--untrusted", compare.each.untrusted, kUntrusted);
  options.flag("--json", compare.json, "print the result as JSON, a line for each seed");
  if (const auto help = options.parse(words)) return PrintText{*help};
  if (launch::is_fleet_file(compare.sketch))
    throw InputError(
        {compare.sketch},
        "compare runs one sketch on several targets, and this is a file of several robots; record "
        "two runs of them, and hold these against each other by robosim replay --over");
  if (!seed.empty() && !seeds.empty()) throw InputError("--seed is one, --seeds are many; give one of them");
  compare.first_seed = compare.last_seed = seed.empty() ? 1 : seed_number(seed);
  if (!seeds.empty()) read_seeds(seeds, compare.first_seed, compare.last_seed);
  shared.finish();
  compare.targets = split_at_commas(compare.targets);
  if (compare.targets.empty()) compare.targets = {"host", "avr", "stm32"};
  if (compare.targets.size() < 2) throw InputError("--target: give two or more to compare, as in host,avr");
  std::vector<std::string> sorted = compare.targets;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) throw InputError("--target " + *twice + " is given twice");
  return compare;
}

}  // namespace robosim::cli
