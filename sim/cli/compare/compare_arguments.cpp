#include "sim/cli/compare/compare_arguments.h"

#include <algorithm>

#include "sim/base/error.h"
#include "sim/cli/run/fleet_arguments.h"
#include "sim/cli/run_options.h"

namespace robosim::cli {
namespace {

/// Parses "host,avr", or "B=host,avr" for one robot.
void read_targets(const std::vector<std::string>& words, CompareArguments& compare) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    const Named part = named(words[i]);
    if (i > 0 && !part.name.empty())
      throw InputError(
          "--target expects two or more targets for all robots, or for one of them, as in B=host,avr");
    if (i == 0) compare.moves = part.name;
    compare.targets.push_back(part.value);
  }
  compare.targets = split_at_commas(compare.targets);
  if (compare.targets.empty()) compare.targets = {"host", "avr", "stm32"};
  if (compare.targets.size() < 2)
    throw InputError("--target: expected two or more targets to compare, as in host,avr");
  std::vector<std::string> sorted = compare.targets;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) throw InputError("--target " + *twice + " is given twice");
}

}  // namespace

Command parse_compare(const std::vector<std::string>& words) {
  CompareArguments compare;
  std::vector<std::string> targets_given;
  std::string seed, seeds;
  Options options("compare", "find the first difference between a sketch on host, AVR and STM32",
                  "Runs a sketch, or several robots, on several targets side by side.");
  options.text("--map", compare.each.map, "MAP", kMapHelp, PossibleValues::map());
  FleetOptions robots(options, compare.each, true);
  options.lists("--target", targets_given, "TARGET",
                "compare two or more of host, avr and stm32 (default: host,avr,stm32); NAME=host,avr changes "
                "the target of only one of several robots",
                targets());
  options.text("--seed", seed, "N", "seed all noise and spread (default: 1)");
  options.text("--seeds", seeds, "A..B", "compare with each of these seeds, until a difference is found");
  RunOptions shared(options, compare.each);
  shared.time();
  shared.common();
  options.flag("--untrusted", compare.each.untrusted, kUntrustedHelp);
  options.flag("--json", compare.json, "print the result as JSON, one line for each seed");
  if (const auto help = options.parse(words)) return *help;
  if (!seed.empty() && !seeds.empty())
    throw InputError("--seed and --seeds exclude each other; give one of them");
  compare.first_seed = compare.last_seed = seed.empty() ? 1 : seed_number(seed);
  if (!seeds.empty()) read_seeds(seeds, compare.first_seed, compare.last_seed);
  shared.finish();
  robots.finish();
  read_targets(targets_given, compare);
  if (!compare.moves.empty()) robots.check_known("--target", compare.moves);
  return compare;
}

}  // namespace robosim::cli
