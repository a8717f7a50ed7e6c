#include "sim/cli/mutate/mutate_arguments.h"

#include <charconv>

#include "sim/cli/options.h"
#include "sim/cli/sweep/sweep_arguments.h"

namespace robosim::cli {

Command parse_mutate(const std::vector<std::string>& words) {
  MutateArguments mutate;
  std::string jobs, seed, count, least;
  Options options("mutate",
                  "Tries the checks of a sketch, or its tests in C++: draws small bugs at random, puts them "
                  "into the sketch one "
                  "at a time, and "
                  "tells which of them no check finds. Needs clang++.");
  options.positional("SKETCH", mutate.sketch, "a folder, .ino file or name; default: the current folder");
  options.text("--checks", mutate.checks, "FILE",
               "these checks in place of the checks.toml beside the sketch");
  options.texts("--tests", mutate.tests, "PROGRAM",
                "a built program of GoogleTest tests, in place of checks; may be repeated");
  options.text("--count", count, "N", "how many bugs that compile; default 20");
  options.text("--seed", seed, "N", "of what is drawn; default 1");
  options.text("--min-score", least, "X", "status 1 if a smaller share, 0 to 1, is found");
  options.text("--jobs", jobs, "N", "runs at a time; default: one for each core");
  options.flag("--json", mutate.json, "one object for programs");
  if (const auto help = options.parse(words)) return PrintText{*help};
  if (!mutate.tests.empty() && !mutate.checks.empty())
    throw InputError("--checks and --tests exclude each other");
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
