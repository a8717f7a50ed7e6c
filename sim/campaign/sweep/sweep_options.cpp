#include "sim/campaign/sweep/sweep_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "sim/base/error.h"
#include "sim/base/option_values.h"
#include "sim/base/units.h"
#include "sim/build/sketch.h"
#include "sim/campaign/analysis/success_rate.h"

namespace robosim::campaign {
namespace {

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

void check_parts(const SweepOptions& sweep) {
  if (!sweep.shard.whole() && sweep.min_rate)
    throw InputError("--min-rate requires all runs; give it with --merge, not with --shard");
  if (sweep.merge.empty()) return;
  refuse_repetition("--merge", sweep.merge);
  if (sweep.csv.empty()) throw InputError("--merge requires --csv, the table to write");
  if (!sweep.shard.whole()) throw InputError("--merge combines all shards; it excludes --shard");
}

}  // namespace

void take(const SweepTexts& texts, SweepOptions& sweep) {
  if (!texts.seeds.empty()) read_seeds(texts.seeds, sweep.first_seed, sweep.last_seed);
  sweep.jobs = number_of_jobs(texts.jobs);
  if (!texts.shard.empty()) sweep.shard = read_shard(texts.shard);
  if (!texts.min_rate.empty()) sweep.min_rate = rate(texts.min_rate);
  sweep.targets = split_at_commas(sweep.targets);
  refuse_sketches("--map", sweep.maps);
  refuse_sketches("--robot", sweep.robots);
  refuse_sketches("--target", sweep.targets);
  refuse_repetition("the sketch", sweep.sketches);
  refuse_repetition("--map", sweep.maps);
  refuse_repetition("--robot", sweep.robots);
  refuse_repetition("--target", sweep.targets);
  if (sweep.resume && sweep.csv.empty()) throw InputError("--resume requires --csv, the table to continue");
  check_parts(sweep);
  if (!sweep.min_rate && (sweep.sure || sweep.stop_early)) {
    throw InputError(std::string(sweep.sure ? "--sure" : "--stop-early") + " requires --min-rate");
  }
  if (sweep.min_rate) check_possible({*sweep.min_rate, sweep.sure}, sweep.last_seed - sweep.first_seed + 1);
}

}  // namespace robosim::campaign
