#include "sim/run/scenery.h"

#include <string>

#include "sim/base/error.h"
#include "sim/trace/trace_hash.h"

namespace robosim::run {

Task::Task(const Errand& errand, const grid::Map& map, const grid::Stripes& stripes)
    : start(errand.start ? *errand.start : grid::default_start(map)),
      network(grid::trace_reachable(map, start)),
      goal(errand.goal ? *errand.goal : judge::default_goal(map, network)),
      progress(goal, map, stripes, network, start) {}

Scenery::Scenery(const grid::Map& map) : map_(map), stripes_(map, map.cell_m), world_(map) {}

void Scenery::prepare(std::size_t number, const Errand& errand) {
  // The first hash detects the processor's vector extensions, which is slow in a virtual machine.
  [[maybe_unused]] static const std::string hashed = trace::TraceHash().text();
  if (number >= prepared_.size()) prepared_.resize(number + 1);
  Prepared& prepared = prepared_[number];
  if (prepared.task && prepared.errand == errand) return;
  prepared = {errand, std::nullopt};
  try {
    prepared.task.emplace(errand, map_, stripes_);
  } catch (const InputError&) {
  }
}

Task Scenery::task(std::size_t number, const Errand& errand) const {
  if (number < prepared_.size() && prepared_[number].task && prepared_[number].errand == errand)
    return *prepared_[number].task;
  return Task(errand, map_, stripes_);
}

}  // namespace robosim::run
