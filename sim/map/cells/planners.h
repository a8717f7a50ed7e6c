// Provides the navigator's planners by name, for a host.
#pragma once

#include <string>
#include <vector>

#include "firmware/src/nav/Plan.h"
#include "sim/map/cells/growing_network.h"

namespace robosim::cells {

/// Growing memory for a path or for planning.
class GrowingMemory {
 public:
  using Id = GrowingNetwork::Id;
  using Cost = std::uint32_t;

  Id* room(std::size_t count) {
    ids_.resize(count);
    return ids_.data();
  }
  Cost* costs(std::size_t count) {
    costs_.resize(count);
    return costs_.data();
  }
  void setSize(std::size_t size) { size_ = size; }
  /// Returns the nodes of a path, both ends included.
  std::vector<Id> way() const { return {ids_.begin(), ids_.begin() + static_cast<std::ptrdiff_t>(size_)}; }

 private:
  std::vector<Id> ids_;
  std::vector<Cost> costs_;
  std::size_t size_ = 0;
};

/// Returns "bfs", "dfs", …
const std::vector<std::string>& planner_names();

/// Returns the default planner, as in AiNavigator: "climb" for a tree, "dijkstra" for other networks.
std::string default_planner(const GrowingNetwork& network);

/// Plans a path. `planner` must be one of planner_names().
nav::Plan plan(const std::string& planner, const GrowingNetwork& network, GrowingNetwork::Id from,
               GrowingNetwork::Id to, GrowingMemory& path);

}  // namespace robosim::cells
