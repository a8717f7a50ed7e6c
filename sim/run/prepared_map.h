// The initial state of simulations on a map, whatever their seed. A process whose forks each make one run
// builds it before it forks, so that all of them share it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sim/grid/map.h"
#include "sim/grid/network.h"
#include "sim/grid/stripes.h"
#include "sim/judge/goal.h"
#include "sim/world/world.h"

namespace robosim::run {

/// Where a robot starts, and its goal. Empty: the map's.
struct Mission {
  std::optional<grid::Start> start;
  std::optional<judge::Goal> goal;
  bool operator==(const Mission&) const = default;
};

/// A mission resolved on a map.
struct ResolvedMission {
  /// The map must outlive it. Throws InputError if the mission makes no sense there.
  ResolvedMission(const Mission& mission, const grid::Map& map, const grid::Stripes& stripes);
  grid::Start start;
  grid::Network network;
  judge::Goal goal;
  judge::Progress progress;
};

class PreparedMap {
 public:
  /// The map must outlive it. Throws InputError if it has too much line (grid::Stripes).
  explicit PreparedMap(const grid::Map& map);

  /// Resolves beforehand the mission that resolve() will need for that agent.
  void prepare(std::size_t number, const Mission& mission);
  /// Throws InputError if the mission makes no sense on the map.
  ResolvedMission resolve(std::size_t number, const Mission& mission) const;

  const grid::Stripes& stripes() const { return stripes_; }
  /// Returns the world as on the map, until a simulation drives on it.
  world::World& world() { return world_; }

 private:
  struct Prepared {
    Mission mission;
    std::optional<ResolvedMission> resolved_mission;  ///< none: the mission is invalid
  };
  const grid::Map& map_;
  const grid::Stripes stripes_;
  world::World world_;
  std::vector<Prepared> prepared_;  ///< by agent number
};

}  // namespace robosim::run
