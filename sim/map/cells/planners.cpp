#include "sim/map/cells/planners.h"

#include <iterator>

#include "firmware/src/nav/Dijkstra.h"
#include "firmware/src/nav/PrunedBfs.h"
#include "firmware/src/nav/Search.h"
#include "firmware/src/nav/TreeWay.h"

namespace robosim::cells {
namespace {

using Id = GrowingNetwork::Id;
using Planner = nav::Plan (*)(const GrowingNetwork&, Id, Id, GrowingMemory&, GrowingMemory&);

struct Named {
  const char* name;
  Planner plan;
};

constexpr Named kPlanners[] = {
    {"bfs", nav::bfs<GrowingNetwork, GrowingMemory, GrowingMemory>},
    {"dfs", nav::dfs<GrowingNetwork, GrowingMemory, GrowingMemory>},
    {"iterative", nav::iterative<GrowingNetwork, GrowingMemory, GrowingMemory>},
    {"pruned", nav::pruned<GrowingNetwork, GrowingMemory, GrowingMemory>},
    {"climb", nav::climb<GrowingNetwork, GrowingMemory, GrowingMemory>},
    {"interval", nav::interval<GrowingNetwork, GrowingMemory, GrowingMemory>},
    {"dijkstra", nav::dijkstra<GrowingNetwork, GrowingMemory, GrowingMemory>},
};

}  // namespace

const std::vector<std::string>& planner_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Named& planner : kPlanners) all.emplace_back(planner.name);
    return all;
  }();
  return names;
}

std::string default_planner(const GrowingNetwork& network) { return network.isTree() ? "climb" : "dijkstra"; }

nav::Plan plan(const std::string& planner, const GrowingNetwork& network, Id from, Id to,
               GrowingMemory& path) {
  GrowingMemory work;
  for (const Named& known : kPlanners)
    if (planner == known.name) return known.plan(network, from, to, path, work);
  throw std::logic_error("there is no planner " + planner);
}

}  // namespace robosim::cells
