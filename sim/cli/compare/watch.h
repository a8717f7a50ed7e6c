// How `robosim compare` looks at a robot: the places of the map as it meets them, and what it asks a run for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/analysis/history.h"
#include "sim/cli/compare/lanes.h"
#include "sim/grid/map.h"
#include "sim/grid/places.h"

namespace robosim::cli {

/// One robot of a lane, in one run.
struct Watched {
  std::size_t robot = 0;
  std::uint64_t seed = 1;
  std::int64_t until_ns = 0;         ///< when the run ends at the latest; in whole milliseconds
  std::vector<wire::Lateness> late;  ///< of its sketch
};

/// By how much a robot's clock is off in a run.
struct ClockOff {
  std::int64_t from_ns = 0;
  int ppm = 0;  ///< too fast, from then on
};

class Watch {
 public:
  /// The map, and where the robots start, are those of `request`.
  explicit Watch(const wire::RunRequest& request);
  Watch(const Watch&) = delete;

  std::size_t robots() const { return places_.size(); }
  /// Must not outlive this.
  analysis::HistoryRecorder recorder_of(const Lane& lane, std::size_t robot) const;
  static wire::RunRequest request_of(const Lane& lane, std::uint64_t seed);
  static bool is_of(const wire::Event& event, std::size_t robot);
  /// Where there are several robots, the others' clocks are as far off the other way: who comes first where
  /// ways cross may be chance, too.
  analysis::History run(Lane& lane, const Watched& watched, const ClockOff& off = {}) const;

 private:
  std::string place_of(std::size_t robot, const wire::Sample& sample) const;

  grid::Map map_;
  std::vector<grid::Places> places_;  ///< as each robot meets them, from its start on
};

}  // namespace robosim::cli
