// The options of a hunt.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/campaign/shard.h"
#include "sim/launch/run_settings.h"

namespace robosim::campaign {

struct HuntOptions {
  std::string sketch;
  std::vector<std::string> maps;  ///< empty = the map next to the sketch, or built-in maps
  bool only_maps = false;         ///< generates no maps
  std::string robot;
  std::vector<std::string> targets;  ///< empty = the chip and the host
  launch::RunSettings each;  ///< common to all runs; its sketch, map, robot, target and seed are ignored
  std::uint64_t seed = 1;    ///< seed of all random choices
  std::uint64_t runs = 400;
  double minutes = 0.0;  ///< wall time after which no run starts; 0 = no limit
  std::size_t jobs = 1;  ///< simultaneous runs
  bool stop_early = false;
  Shard shard;                     ///< selects some of the runs
  std::vector<std::string> merge;  ///< folders of other shards; if given, nothing is run
};

}  // namespace robosim::campaign
