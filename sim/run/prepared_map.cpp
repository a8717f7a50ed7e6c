#include "sim/run/prepared_map.h"

#include <string>

#include "sim/base/error.h"
#include "sim/run/trace/trace_hash.h"

namespace robosim::run {

ResolvedMission::ResolvedMission(const Mission& mission, const map::Map& map, const map::Stripes& stripes)
    : start(mission.start ? *mission.start : map::default_start(map)),
      network(map::trace_reachable(map, start)),
      goal(mission.goal ? *mission.goal : judge::default_goal(map, network)),
      progress(goal, map, stripes, network, start) {}

PreparedMap::PreparedMap(const map::Map& map) : map_(map), world_(map) {}

void PreparedMap::prepare(std::size_t number, const Mission& mission) {
  // Computes the process's first hash now. The first hash detects vector extensions, which is slow in a
  // virtual machine.
  [[maybe_unused]] static const std::string hashed = trace::TraceHash().text();
  if (number >= prepared_.size()) prepared_.resize(number + 1);
  Prepared& prepared = prepared_[number];
  if (prepared.resolved_mission && prepared.mission == mission) return;
  prepared = {mission, std::nullopt};
  try {
    prepared.resolved_mission.emplace(mission, map_, stripes());
  } catch (const InputError&) {
  }
}

ResolvedMission PreparedMap::resolve(std::size_t number, const Mission& mission) const {
  if (number < prepared_.size() && prepared_[number].resolved_mission && prepared_[number].mission == mission)
    return *prepared_[number].resolved_mission;
  return ResolvedMission(mission, map_, stripes());
}

}  // namespace robosim::run
