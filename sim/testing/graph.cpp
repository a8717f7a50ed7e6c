#include "robosim/testing/graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "sim/base/pluralize.h"

namespace robosim::testing {
namespace {

std::string sizes(const Graph& graph) {
  return pluralize(static_cast<std::size_t>(graph.stations()), "station") + ", " +
         pluralize(static_cast<std::size_t>(graph.junctions()), "junction");
}

/// Returns whether the graphs agree if arm 0 of node 0 in `found` is arm `arm` of node `node` in `truth`.
/// Walks both graphs in the same order, from known nodes to new ones.
bool agree(const Graph& truth, const Graph& found, int node, int arm) {
  struct Place {
    int node = Graph::kBlocked;
    int turn = 0;  ///< arm k in `found` is arm k + turn in `truth`
  };
  std::vector<Place> place(found.nodes.size());
  std::vector<bool> taken(truth.nodes.size());
  std::vector<std::size_t> reached{0};
  place[0] = {node, arm};
  taken[static_cast<std::size_t>(node)] = true;
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const std::size_t at = reached[next];
    const std::vector<Graph::End>& here = found.nodes[at].arms;
    const std::vector<Graph::End>& there = truth.nodes[static_cast<std::size_t>(place[at].node)].arms;
    if (here.size() != there.size()) return false;
    const int arms = static_cast<int>(here.size());
    for (int k = 0; k < arms; ++k) {
      const Graph::End& mine = here[static_cast<std::size_t>(k)];
      const Graph::End& its = there[static_cast<std::size_t>((k + place[at].turn) % arms)];
      if ((mine.node == Graph::kBlocked) != (its.node == Graph::kBlocked)) return false;
      if (mine.node == Graph::kBlocked) continue;
      Place& other = place[static_cast<std::size_t>(mine.node)];
      const int others =
          std::max(1, static_cast<int>(found.nodes[static_cast<std::size_t>(mine.node)].arms.size()));
      const int turn = ((its.arm - mine.arm) % others + others) % others;
      if (other.node == Graph::kBlocked) {
        if (taken[static_cast<std::size_t>(its.node)]) return false;
        taken[static_cast<std::size_t>(its.node)] = true;
        other = {its.node, turn};
        reached.push_back(static_cast<std::size_t>(mine.node));
      } else if (other.node != its.node || other.turn != turn) {
        return false;
      }
    }
  }
  return reached.size() == found.nodes.size();
}

}  // namespace

int Graph::stations() const {
  return static_cast<int>(
      std::count_if(nodes.begin(), nodes.end(), [](const Node& node) { return node.arms.size() < 2; }));
}

int Graph::junctions() const { return static_cast<int>(nodes.size()) - stations(); }

std::string difference(const Graph& truth, const Graph& found) {
  if (truth.stations() != found.stations() || truth.junctions() != found.junctions())
    return fmt::format("it has {}, but the floor has {}", sizes(found), sizes(truth));
  if (found.nodes.empty()) return "";
  for (int node = 0; node < static_cast<int>(truth.nodes.size()); ++node) {
    const int arms = static_cast<int>(truth.nodes[static_cast<std::size_t>(node)].arms.size());
    for (int arm = 0; arm < std::max(1, arms); ++arm)
      if (agree(truth, found, node, arm)) return "";
  }
  return "it has as many stations and junctions as the floor, but its lines connect them differently";
}

bool IsTheSameGraphAs::MatchAndExplain(const Graph& found, std::ostream* out) const {
  const std::string sentence = difference(truth_, found);
  if (out) *out << sentence;
  return sentence.empty();
}
void IsTheSameGraphAs::DescribeTo(std::ostream* out) const {
  *out << "is the floor's graph: " << sizes(truth_);
}
void IsTheSameGraphAs::DescribeNegationTo(std::ostream* out) const { *out << "is not the floor's graph"; }

void PrintTo(const Graph& graph, std::ostream* out) { *out << sizes(graph); }

}  // namespace robosim::testing
