#include "sim/cli/mutate/mutate_arguments.h"

#include <charconv>

#include "sim/cli/options.h"

namespace robosim::cli {

Command parse_mutate(const std::vector<std::string>& words) {
  MutateArguments mutate;
  std::string jobs, seed, count, least;
  Options options("mutate", "plant small bugs in a sketch and report which ones its checks miss",
                  "Draws the bugs at random and tries them one at a time. Needs clang++.");
  options.positional("[SKETCH]", mutate.sketch, kSketchHelp, PossibleValues::sketch());
  options.text("--checks", mutate.checks, "FILE",
               "run the checks of this file instead of the checks.toml next to the sketch",
               PossibleValues::file());
  options.texts("--tests", mutate.tests, "PROGRAM",
                "run this built GoogleTest program instead of checks; may be repeated",
                PossibleValues::file());
  options.text("--count", count, "N", "plant this many bugs that compile (default: 20)");
  options.text("--seed", seed, "N", "seed the choice of bugs (default: 1)");
  options.text("--min-score", least, "X",
               "exit with status 1 if less than this share of the bugs is found, 0 to 1");
  options.text("--jobs", jobs, "N", kJobsHelp);
  options.flag("--json", mutate.json, "print the result as JSON");
  if (const auto help = options.parse(words)) return *help;
  if (!mutate.tests.empty() && !mutate.checks.empty())
    throw InputError("--checks and --tests exclude each other; give only one of them");
  mutate.jobs = number_of_jobs(jobs);
  if (!seed.empty()) mutate.seed = seed_number(seed);
  if (!count.empty()) mutate.count = whole_number("--count", count, 1, 100'000);
  if (!least.empty()) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(least.data(), least.data() + least.size(), value);
    if (error != std::errc() || end != least.data() + least.size() || !(value >= 0.0 && value <= 1.0))
      refuse_value("--min-score", least, "a share from 0 to 1, as in 0.8");
    mutate.min_score = value;
  }
  return mutate;
}

}  // namespace robosim::cli
