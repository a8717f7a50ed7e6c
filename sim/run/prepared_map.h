// Builds the part of a simulation's initial state that depends on the map, but not on the seed. A process
// that forks for each run builds this state first, so that all forks share it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sim/judge/goal.h"
#include "sim/map/map.h"
#include "sim/map/network.h"
#include "sim/map/stripes.h"
#include "sim/world/world.h"

namespace robosim::run {

/// A robot's start and goal. An empty member selects the start or the goal of the map.
struct Mission {
  std::optional<map::Start> start;
  std::optional<judge::Goal> goal;
  bool operator==(const Mission&) const = default;
};

/// A mission that has been resolved on a map.
struct ResolvedMission {
  /// Resolves a mission on a map, which must outlive this object. Throws InputError if the mission is
  /// impossible on the map.
  ResolvedMission(const Mission& mission, const map::Map& map, const map::Stripes& stripes);
  map::Start start;
  map::Network network;
  judge::Goal goal;
  judge::Progress progress;
};

class PreparedMap {
 public:
  /// Prepares a map, which must outlive this object. Throws InputError if the total length of the map's lines
  /// is too large (map::Stripes).
  explicit PreparedMap(const map::Map& map);

  /// Resolves an agent's mission in advance, for a later call of resolve().
  void prepare(std::size_t number, const Mission& mission);
  /// Returns an agent's resolved mission. Throws InputError if the mission is impossible on the map.
  ResolvedMission resolve(std::size_t number, const Mission& mission) const;

  const map::Stripes& stripes() const { return world_.floor().stripes(); }
  /// Returns the world. The world is in the map's initial state until a simulation uses it.
  world::World& world() { return world_; }

 private:
  struct Prepared {
    Mission mission;
    std::optional<ResolvedMission> resolved_mission;  ///< empty if the mission is invalid
  };
  const map::Map& map_;
  world::World world_;
  std::vector<Prepared> prepared_;  ///< indexed by agent number
};

}  // namespace robosim::run
