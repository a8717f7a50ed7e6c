// The options of a sweep: every sketch on every map with every robot on every target, each with all seeds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/campaign/shard.h"
#include "sim/launch/run_settings.h"

namespace robosim::campaign {

struct SweepOptions {
  std::vector<std::string> sketches;
  std::vector<std::string> maps;  ///< for maps, robots and targets, empty = the choice of `run`
  std::vector<std::string> robots;
  std::vector<std::string> targets;
  launch::RunSettings each;  ///< common to all runs; its sketch, map, robot, target and seed are ignored
  std::uint64_t first_seed = 1;
  std::uint64_t last_seed = 100;
  std::size_t jobs = 1;  ///< simultaneous runs
  std::string csv;       ///< a file; empty = none
  bool resume = false;
  std::optional<double> min_rate;
  bool sure = false;               ///< the runs must prove min_rate, see analysis::Demand
  bool stop_early = false;         ///< skips runs that cannot change whether min_rate is met
  Shard shard;                     ///< selects some of the runs
  std::vector<std::string> merge;  ///< tables of other shards, whose runs are not repeated
};

/// Options that are still text: --seeds, --jobs, --shard and --min-rate; empty = not given.
struct SweepTexts {
  std::string seeds, jobs, shard, min_rate;
};
/// Converts the texts, stores the values in the options, and checks that all options are possible together.
/// Throws InputError. A command line and a file of checks use this function, so each key means the same as
/// its flag.
void take(const SweepTexts& texts, SweepOptions& options);

}  // namespace robosim::campaign
