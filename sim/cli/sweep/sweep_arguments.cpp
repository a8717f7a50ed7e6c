#include "sim/cli/sweep/sweep_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <system_error>
#include <thread>

#include "sim/base/error.h"
#include "sim/base/units.h"
#include "sim/build/sketch.h"
#include "sim/campaign/analysis/success_rate.h"
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

// Rejects sketches among the values of an option, as in "--map oval MySketch".
void refuse_sketches(const char* option, const std::vector<std::string>& words) {
  const auto ours = build::stock_sketches();
  for (const std::string& word : words) {
    std::error_code error;
    const std::string ending = std::filesystem::path(word).extension().string();
    if (ending == ".ino" || ending == ".elf" || std::filesystem::is_directory(word, error) ||
        std::find(ours.begin(), ours.end(), word) != ours.end()) {
      throw InputError(fmt::format("{}: “{}” is a sketch; put sketches before the options", option, word));
    }
  }
}

void check_possible(const analysis::Demand& demand, std::uint64_t seeds) {
  if (analysis::needed_successes(demand, static_cast<std::int64_t>(seeds))) return;
  const auto needed = analysis::needed_runs(demand);
  if (!needed)
    throw InputError("--sure: no number of runs can prove a rate of 1; demand less, as in --min-rate 0.99");
  throw InputError(fmt::format("--sure: {} {} cannot prove a rate of {}, even if all runs succeed; {} could",
                               seeds, seeds == 1 ? "seed" : "seeds", demand.rate, *needed));
}

void check_parts(const SweepArguments& sweep) {
  if (!sweep.shard.whole() && sweep.min_rate)
    throw InputError("--min-rate requires all runs; give it with --merge, not with --shard");
  if (sweep.merge.empty()) return;
  refuse_repetition("--merge", sweep.merge);
  if (sweep.csv.empty()) throw InputError("--merge requires --csv, the table to write");
  if (sweep.json)
    throw InputError("--merge does not repeat the runs of its tables, so --json would lack them");
  if (!sweep.shard.whole()) throw InputError("--merge combines all shards; it excludes --shard");
}

}  // namespace

void read_seeds(const std::string& text, std::uint64_t& first, std::uint64_t& last) {
  constexpr const char* kForms = "one seed or a range FIRST..LAST, as in 1..100";
  const std::size_t dots = text.find("..");
  const auto number = [](const std::string& digits) -> std::optional<std::uint64_t> {
    std::uint64_t value = 0;
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    return error == std::errc() && stop == end ? std::optional(value) : std::nullopt;
  };
  const auto from = number(text.substr(0, dots));
  const auto to = dots == text.npos ? from : number(text.substr(dots + 2));
  if (!from || !to) {
    // Recognizes ranges in the notation of other tools: 1-30, 1:30, 1...30.
    const std::size_t other = text.find_first_not_of("0123456789");
    const std::size_t second = other == text.npos ? text.npos : text.find_first_of("0123456789", other);
    const bool is_range = other != 0 && second != text.npos && number(text.substr(second)).has_value();
    refuse_value("--seeds", text, kForms,
                 is_range ? fmt::format("; did you mean {}..{}?", text.substr(0, other), text.substr(second))
                          : fmt::format("; seeds are whole numbers up to {}", kMostSeed));
  }
  first = *from;
  last = *to;
  if (last < first) refuse_value("--seeds", text, kForms, "; the first seed is greater than the last");
  if (last - first >= kMostSeeds) refuse_value("--seeds", text, fmt::format("at most {} seeds", kMostSeeds));
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
  options.text("--seeds", seeds, "A..B", "run from the first to the last seed (default: 1..100)");
  options.text("--jobs", jobs, "N", kJobsHelp);
  options.text("--csv", sweep.csv, "FILE", "write a row for each run to this file", PossibleValues::file());
  options.flag("--resume", sweep.resume, "continue the table of --csv; skip its finished runs");
  options.text("--shard", shard, "I/N", kShardHelp);
  options.lists("--merge", sweep.merge, "FILE",
                "take the runs of these tables of --shard instead of doing them again",
                PossibleValues::file());
  options.text("--min-rate", min_rate, "R",
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
  if (sweep.resume && sweep.csv.empty()) throw InputError("--resume requires --csv, the table to continue");
  if (sweep.resume && sweep.json) {
    throw InputError("--resume does not repeat the runs of the --csv file, so --json would lack them");
  }
  check_parts(sweep);
  if (!sweep.min_rate && (sweep.sure || sweep.stop_early)) {
    throw InputError(std::string(sweep.sure ? "--sure" : "--stop-early") + " requires --min-rate");
  }
  if (sweep.min_rate) check_possible({*sweep.min_rate, sweep.sure}, sweep.last_seed - sweep.first_seed + 1);
  return sweep;
}

}  // namespace robosim::cli
