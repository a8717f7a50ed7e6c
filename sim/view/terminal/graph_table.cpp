#include "sim/view/terminal/graph_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "sim/base/pluralize.h"
#include "sim/view/terminal/text.h"

namespace robosim::terminal {
namespace {

using map::Arm;
using map::TrueGraph;
using Behind = Arm::Behind;

std::string at(map::CellAt cell) { return fmt::format("at {},{}", cell.x, cell.y); }

const map::GraphJunction& junction(const TrueGraph& graph, int number) {
  return graph.junctions[static_cast<std::size_t>(number - 1)];
}
const map::GraphStation& station(const TrueGraph& graph, int number) {
  return graph.stations[static_cast<std::size_t>(number - 1)];
}

std::string node_name(const TrueGraph& graph, Behind kind, int number) {
  if (kind == Behind::station)
    return fmt::format("{} {}", station_name(graph, number), at(station(graph, number).cell));
  return fmt::format("J{} {}", number, at(junction(graph, number).cell));
}

// Returns the name of a link's other end, without its position.
std::string behind(const TrueGraph& graph, const Arm& arm) {
  switch (arm.behind) {
    case Behind::station:
      return station_name(graph, arm.id);
    case Behind::junction:
      return fmt::format("J{}", arm.id);
    case Behind::blocked:
      return "an obstacle " + at(arm.obstacle);
    case Behind::nothing:
      break;
  }
  return "nothing";
}

std::string link_text(const Arm& arm) { return fmt::format("{} {}", direction_word(arm.out), arm.length); }

// Prints the depth-first tree. Does not use recursion, because the tree may be as deep as it has nodes.
class Tree {
 public:
  Tree(const TrueGraph& graph, bool utf8)
      : graph_(graph),
        utf8_(utf8),
        junctions_(graph.junctions.size(), false),
        stations_(graph.stations.size(), false) {}

  std::vector<std::string> lines() {
    if (!graph_.stations.empty()) {
      root(Behind::station, 1);
    } else if (!graph_.junctions.empty()) {
      root(Behind::junction, 1);
    }
    while (!open_.empty()) next();
    return std::move(lines_);
  }

 private:
  struct Open {
    std::vector<Arm> arms;  // not yet shown
    std::size_t shown;
    std::string indent;
  };

  void root(Behind kind, int number) {
    lines_.push_back(node_name(graph_, kind, number));
    note(kind, number);
    if (kind == Behind::station) {
      const Arm& arm = station(graph_, number).arm;
      if (arm.behind != Behind::nothing) open_.push_back({{arm}, 0, ""});
    } else {
      open_.push_back({junction(graph_, number).arms, 0, ""});
    }
  }
  void note(Behind kind, int number) {
    (kind == Behind::station ? stations_ : junctions_)[static_cast<std::size_t>(number - 1)] = true;
  }
  void next() {
    Open& here = open_.back();
    if (here.shown == here.arms.size()) {
      open_.pop_back();
      return;
    }
    const Arm arm = here.arms[here.shown++];
    const bool last = here.shown == here.arms.size();
    const std::string indent = here.indent;
    std::string line = indent + (utf8_ ? last ? "└─ " : "├─ " : last ? "`- " : "|- ") + link_text(arm) + ": ";
    const bool is_junction = arm.behind == Behind::junction;
    if (is_junction && junctions_[static_cast<std::size_t>(arm.id - 1)]) {
      lines_.push_back(line + behind(graph_, arm) + ", see above");
      return;
    }
    const bool is_node = is_junction || arm.behind == Behind::station;
    lines_.push_back(line + (is_node ? node_name(graph_, arm.behind, arm.id) : behind(graph_, arm)));
    if (is_node) note(arm.behind, arm.id);
    if (!is_junction) return;
    Open deeper{{}, 0, indent + (last ? "   " : utf8_ ? "│  " : "|  ")};
    const auto& arms = junction(graph_, arm.id).arms;
    for (std::size_t i = 1; i < arms.size(); ++i)  // counter-clockwise: rightmost arm first
      deeper.arms.push_back(arms[(static_cast<std::size_t>(arm.slot) + i) % arms.size()]);
    open_.push_back(std::move(deeper));
  }

  const TrueGraph& graph_;
  bool utf8_;
  std::vector<bool> junctions_, stations_;  // already shown
  std::vector<Open> open_;
  std::vector<std::string> lines_;
};

// The maximum number of nodes in a printed tree. A deep tree's indentation takes space quadratic in its
// depth.
constexpr std::size_t kMostTreeNodes = 500;

}  // namespace

const char* direction_word(map::Direction d) {
  constexpr const char* kWords[] = {"east", "south", "west", "north"};
  return kWords[static_cast<int>(d)];
}

std::string graph_summary(const TrueGraph& graph) {
  std::string text =
      fmt::format("{}, {}, {}", pluralize(graph.stations.size(), "station"),
                  pluralize(graph.junctions.size(), "junction"), pluralize(line_count(graph), "link"));
  const std::size_t cycles = cycle_count(graph);
  text += cycles == 0 ? "; a tree" : "; " + pluralize(cycles, "cycle");
  if (!graph.unreachable.empty()) {
    text += fmt::format("; unreachable: {} (", pluralize(graph.unreachable.size(), "dead end"));
    constexpr std::size_t kNamed = 5;
    for (std::size_t i = 0; i < std::min(graph.unreachable.size(), kNamed); ++i)
      text += fmt::format("{}{},{}", i ? " " : "", graph.unreachable[i].x, graph.unreachable[i].y);
    text += graph.unreachable.size() > kNamed ? " …)" : ")";
  }
  return text;
}

std::vector<std::string> graph_lines(const TrueGraph& graph, int columns, Look look) {
  if (graph.stations.size() + graph.junctions.size() <= kMostTreeNodes) {
    std::vector<std::string> tree = Tree(graph, look.utf8).lines();
    const bool fits = std::all_of(tree.begin(), tree.end(),
                                  [&](const std::string& line) { return width_of(line) <= columns; });
    if (fits) return tree;
  }
  std::vector<std::string> lines;
  int number = 0;
  for (const map::GraphStation& s : graph.stations) {
    ++number;
    lines.push_back(fmt::format("{}: {} {}", node_name(graph, Behind::station, number), link_text(s.arm),
                                behind(graph, s.arm)));
  }
  number = 0;
  for (const map::GraphJunction& j : graph.junctions) {
    std::string line = node_name(graph, Behind::junction, ++number) + ":";
    for (std::size_t i = 0; i < j.arms.size(); ++i)
      line += fmt::format("{} {} {}", i ? "," : "", link_text(j.arms[i]), behind(graph, j.arms[i]));
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string station_name(const TrueGraph& graph, int number) {
  const std::string& name = station(graph, number).name;
  return name.empty() ? fmt::format("S{}", number) : fmt::format("S{} {}", number, name);
}

int find_station(const TrueGraph& graph, const std::string& answer) {
  for (std::size_t i = 0; i < graph.stations.size(); ++i)
    if (!graph.stations[i].name.empty() && graph.stations[i].name == answer) return static_cast<int>(i) + 1;
  const char* begin = answer.data();
  const char* end = begin + answer.size();
  if (begin != end && (*begin == 'S' || *begin == 's')) ++begin;
  int number = 0;
  const auto [stop, error] = std::from_chars(begin, end, number);
  const bool exists = error == std::errc() && stop == end && number >= 1 &&
                      static_cast<std::size_t>(number) <= graph.stations.size();
  return exists ? number : 0;
}

}  // namespace robosim::terminal
