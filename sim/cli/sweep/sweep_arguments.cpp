#include "sim/cli/sweep/sweep_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <thread>

#include "sim/analysis/success_rate.h"
#include "sim/base/error.h"
#include "sim/base/units.h"
#include "sim/build/sketch.h"
#include "sim/cli/run_options.h"

namespace robosim::cli {
namespace {

constexpr std::uint64_t kMostJobs = 1024;
constexpr std::uint64_t kMostSeeds = 1'000'000;

double rate(const std::string& text) {
  const auto value = parse_quantity(text, Dimension::ratio);
  if (!value || *value < 0.0 || *value > 1.0)
    refuse_value("--min-rate", text, "a share from 0 to 1, as in 0.99 or 99%");
  return *value;
}

void refuse_repetition(const char* what, std::vector<std::string> names) {
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice != names.end()) throw InputError(fmt::format("{} {} is given twice", what, *twice));
}

// "--map oval MySketch" would take the sketch for a map.
void refuse_sketches(const char* option, const std::vector<std::string>& words) {
  const auto ours = build::stock_sketches();
  for (const std::string& word : words) {
    std::error_code error;
    const std::string ending = std::filesystem::path(word).extension().string();
    if (ending == ".ino" || ending == ".elf" || std::filesystem::is_directory(word, error) ||
        std::find(ours.begin(), ours.end(), word) != ours.end()) {
      throw InputError(fmt::format("{}: “{}” is a sketch; sketches stand before the options", option, word));
    }
  }
}

void check_possible(const analysis::Demand& demand, std::uint64_t seeds) {
  if (analysis::needed_successes(demand, static_cast<std::int64_t>(seeds))) return;
  const auto needed = analysis::needed_runs(demand);
  if (!needed)
    throw InputError("--sure: no number of runs can show that a rate is 1; ask for less, as in 0.99");
  throw InputError(fmt::format("--sure: {} {} cannot show a rate of {}, even if all runs succeed; {} could",
                               seeds, seeds == 1 ? "seed" : "seeds", demand.rate, *needed));
}

void check_parts(const SweepArguments& sweep) {
  if (!sweep.shard.whole() && sweep.min_rate)
    throw InputError("--min-rate is judged by all runs; give it with --merge, not with --shard");
  if (sweep.merge.empty()) return;
  refuse_repetition("--merge", sweep.merge);
  if (sweep.csv.empty()) throw InputError("--merge writes one table of several; give --csv too");
  if (sweep.json)
    throw InputError("--merge does not make the runs again that tables have, so --json lacks them");
  if (!sweep.shard.whole()) throw InputError("--merge is of all shards; it goes without --shard");
}

}  // namespace

void read_seeds(const std::string& text, std::uint64_t& first, std::uint64_t& last) {
  const std::size_t dots = text.find("..");
  first = whole_number("--seeds", text.substr(0, dots), 0, kMostSeed);
  last = whole_number("--seeds", dots == std::string::npos ? text : text.substr(dots + 2), 0, kMostSeed);
  if (last < first) refuse_value("--seeds", text, "the first and the last seed, as in 1..100");
  if (last - first >= kMostSeeds) refuse_value("--seeds", text, fmt::format("{} seeds at most", kMostSeeds));
}

std::vector<std::string> split_at_commas(const std::vector<std::string>& words) {
  std::vector<std::string> parts;
  for (const std::string& word : words) {
    for (std::size_t at = 0; at <= word.size();) {
      parts.push_back(word.substr(at, word.find(',', at) - at));
      at += parts.back().size() + 1;
    }
  }
  return parts;
}

std::size_t number_of_jobs(const std::string& text) {
  if (text.empty()) return std::max(1u, std::thread::hardware_concurrency());
  return whole_number("--jobs", text, 1, kMostJobs);
}

Command parse_sweep(const std::vector<std::string>& words) {
  SweepArguments sweep;
  std::string seeds, jobs, shard, min_rate;
  Options options(
      "sweep",
      "Runs each sketch on each map with each robot on each target, with all seeds. The result is "
      "the same for any number of jobs.");
  options.positionals("SKETCH", sweep.sketches,
                      "folders, .ino files or names, before the options; default: the current folder");
  options.lists("--map", sweep.maps, "MAP...", "files, or names of sample maps");
  options.lists("--robot", sweep.robots, "ROBOT...", "files, or names of stock robots");
  options.lists("--target", sweep.targets, "TARGET...", "host, avr, stm32");
  options.text("--seeds", seeds, "A..B", "first and last seed; default: 1..100");
  options.text("--jobs", jobs, "N", "runs at a time; default: one for each core");
  options.text("--csv", sweep.csv, "FILE", "a row for each run");
  options.flag("--resume", sweep.resume, "go on with the --csv file: its runs are not made again");
  options.text("--shard", shard, "I/N",
               "make only the I-th of N parts of the runs; --merge brings them together");
  options.lists("--merge", sweep.merge, "FILE...", "tables of the shards: their runs are not made again");
  options.text("--min-rate", min_rate, "R", "exit status 1 if less than this share reaches the goal");
  options.flag("--sure", sweep.sure, "the runs must show --min-rate to hold in general, at 95 % confidence");
  options.flag("--stop-early", sweep.stop_early,
               "leave out runs that cannot change whether --min-rate is met");
  options.flag("--json", sweep.json, "print a line of JSON for each run");
  RunOptions shared(options, sweep.each);
  shared.task();
  shared.time();
  shared.common();
  options.flag("--sanitize", sweep.each.sanitize,
               "the sketch checks itself, as with run --sanitize (host only)");
  options.flag("--untrusted", sweep.each.untrusted, kUntrusted);
  if (const auto help = options.parse(words)) return PrintText{*help};
  if (!seeds.empty()) read_seeds(seeds, sweep.first_seed, sweep.last_seed);
  sweep.jobs = number_of_jobs(jobs);
  if (!shard.empty()) sweep.shard = read_shard(shard);
  if (!min_rate.empty()) sweep.min_rate = rate(min_rate);
  shared.finish();
  sweep.targets = split_at_commas(sweep.targets);
  refuse_sketches("--map", sweep.maps);
  refuse_sketches("--robot", sweep.robots);
  refuse_sketches("--target", sweep.targets);
  refuse_repetition("the sketch", sweep.sketches);
  refuse_repetition("--map", sweep.maps);
  refuse_repetition("--robot", sweep.robots);
  refuse_repetition("--target", sweep.targets);
  if (sweep.resume && sweep.csv.empty()) throw InputError("--resume goes on with a file; give --csv too");
  if (sweep.resume && sweep.json) {
    throw InputError(
        "--resume does not make the runs again that are in the --csv file, so --json lacks them");
  }
  check_parts(sweep);
  if (!sweep.min_rate && (sweep.sure || sweep.stop_early)) {
    throw InputError(std::string(sweep.sure ? "--sure" : "--stop-early") + " goes with --min-rate");
  }
  if (sweep.min_rate) check_possible({*sweep.min_rate, sweep.sure}, sweep.last_seed - sweep.first_seed + 1);
  return sweep;
}

}  // namespace robosim::cli
