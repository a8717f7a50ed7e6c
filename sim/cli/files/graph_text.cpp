#include "sim/cli/files/graph_text.h"

#include <fmt/format.h>

#include <iterator>
#include <vector>

#include "sim/base/counted.h"

namespace robosim::cli {
namespace {

using grid::Arm;
using grid::CellAt;
using grid::TrueGraph;
using Behind = Arm::Behind;

// One end of a line: a slot of a junction, or a station.
struct End {
  Behind kind;
  int id;
  int slot;
};

// Calls visit(end, arm) for each line once: from stations first, then from junctions, in the order of
// numbers.
template <typename Visit>
void for_each_line(const TrueGraph& graph, Visit visit) {
  int id = 0;
  for (const grid::GraphStation& station : graph.stations) {
    ++id;
    if (station.arm.behind == Behind::nothing) continue;
    if (station.arm.behind != Behind::station || station.arm.id > id)
      visit(End{Behind::station, id, 0}, station.arm);
  }
  id = 0;
  for (const grid::GraphJunction& junction : graph.junctions) {
    ++id;
    for (int slot = 0; const Arm& arm : junction.arms) {
      const bool first = arm.id > id || (arm.id == id && arm.slot > slot);
      if (arm.behind == Behind::blocked || (arm.behind == Behind::junction && first))
        visit(End{Behind::junction, id, slot}, arm);
      ++slot;
    }
  }
}

std::string place(CellAt cell) { return fmt::format("[{}, {}]", cell.x, cell.y); }

std::string slot_json(const Arm& arm) {
  switch (arm.behind) {
    case Behind::station:
      return fmt::format("{{\"station\": {}}}", arm.id);
    case Behind::junction:
      return fmt::format("{{\"junction\": {}}}", arm.id);
    case Behind::blocked:
      return fmt::format("{{\"blocked\": {}}}", place(arm.obstacle));
    case Behind::nothing:
      break;
  }
  return "null";
}

std::string end_json(Behind kind, int id, int slot) {
  return kind == Behind::station ? fmt::format("{{\"station\": {}}}", id)
                                 : fmt::format("{{\"junction\": {}, \"slot\": {}}}", id, slot);
}

// Elements of a JSON list, one a line.
class List {
 public:
  List(std::string& out, const char* key) : out_(out) { out_ += fmt::format(",\n  \"{}\": [", key); }
  void add(const std::string& element) {
    out_ += empty_ ? "\n    " : ",\n    ";
    out_ += element;
    empty_ = false;
  }
  void end() { out_ += empty_ ? "]" : "\n  ]"; }

 private:
  std::string& out_;
  bool empty_ = true;
};

std::string arm_text(const Arm& arm) {
  switch (arm.behind) {
    case Behind::station:
      return fmt::format("station {} in {}", arm.id, arm.length);
    case Behind::junction:
      return fmt::format("junction {}.{} in {}", arm.id, arm.slot, arm.length);
    case Behind::blocked:
      return fmt::format("obstacle at {},{} after {}", arm.obstacle.x, arm.obstacle.y, arm.length);
    case Behind::nothing:
      break;
  }
  return "nothing";
}

// Within a string of the dot language.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

}  // namespace

std::string graph_text(const grid::Map& map, const grid::Start& start, const TrueGraph& graph) {
  std::size_t moves = 0;
  for_each_line(graph, [&](const End&, const Arm& arm) { moves += static_cast<std::size_t>(arm.length); });
  std::string out =
      fmt::format("{}: from {},{},{} {}, {}, {} of {}, {}\n", map.name, start.cell.x, start.cell.y,
                  letter(start.facing), counted(graph.stations.size(), "station"),
                  counted(graph.junctions.size(), "junction"), counted(grid::line_count(graph), "line"),
                  counted(moves, "move"), counted(grid::cycle_count(graph), "cycle"));
  return out + graph_tables(graph);
}

std::string graph_tables(const TrueGraph& graph) {
  std::string out;
  auto end = std::back_inserter(out);
  const auto at = [](CellAt cell) { return fmt::format("{},{}", cell.x, cell.y); };
  if (!graph.stations.empty()) out += "\nstation   at         leads to (junction.slot), in moves\n";
  for (int id = 0; const grid::GraphStation& station : graph.stations) {
    const std::string name = station.name.empty() ? "" : fmt::format("  \"{}\"", station.name);
    fmt::format_to(end, "{:<9} {:<10} {}{}\n", ++id, at(station.cell), arm_text(station.arm), name);
  }
  if (!graph.junctions.empty())
    out += "\njunction  at         slots 0, 1, 2, … lead to (junction.slot), in moves\n";
  for (int id = 0; const grid::GraphJunction& junction : graph.junctions) {
    fmt::format_to(end, "{:<9} {:<10}", ++id, at(junction.cell));
    for (const char* separator = " "; const Arm& arm : junction.arms) {
      fmt::format_to(end, "{}{}", separator, arm_text(arm));
      separator = " | ";
    }
    out += '\n';
  }
  if (!graph.unreachable.empty()) out += "\nnot reachable:";
  for (const CellAt cell : graph.unreachable) out += ' ' + at(cell);
  if (!graph.unreachable.empty()) out += '\n';
  return out;
}

std::string graph_members(const TrueGraph& graph) {
  std::string out;
  List stations(out, "stations");
  for (int id = 0; const grid::GraphStation& station : graph.stations) {
    const std::string name = station.name.empty() ? "" : fmt::format(", \"name\": \"{}\"", station.name);
    stations.add(
        fmt::format("{{\"id\": {}, \"x\": {}, \"y\": {}{}}}", ++id, station.cell.x, station.cell.y, name));
  }
  stations.end();
  List junctions(out, "junctions");
  for (int id = 0; const grid::GraphJunction& junction : graph.junctions) {
    std::string slots;
    for (const Arm& arm : junction.arms) slots += (slots.empty() ? "" : ", ") + slot_json(arm);
    junctions.add(fmt::format("{{\"id\": {}, \"x\": {}, \"y\": {}, \"slots\": [{}]}}", ++id, junction.cell.x,
                              junction.cell.y, slots));
  }
  junctions.end();
  List unreachable(out, "unreachable");
  for (const CellAt cell : graph.unreachable) unreachable.add(place(cell));
  unreachable.end();
  return out;
}

std::string graph_json(const grid::Start& start, const TrueGraph& graph) {
  std::string out = fmt::format("{{\n  \"schema\": \"robosim.graph/1\",\n  \"start\": [{}, {}, \"{}\"]",
                                start.cell.x, start.cell.y, letter(start.facing));
  out += graph_members(graph);
  List edges(out, "edges");
  for_each_line(graph, [&](const End& from, const Arm& arm) {
    edges.add(fmt::format(
        "{{\"from\": {}, \"to\": {}, \"length\": {}}}", end_json(from.kind, from.id, from.slot),
        arm.behind == Behind::blocked ? slot_json(arm) : end_json(arm.behind, arm.id, arm.slot), arm.length));
  });
  edges.end();
  out += "\n}\n";
  return out;
}

std::string graph_dot(const grid::Map& map, const TrueGraph& graph) {
  std::string out = fmt::format(
      "graph {} {{\n  layout=neato; overlap=true; splines=true\n  node [width=0.4, height=0.4, "
      "margin=0.03]\n",
      quoted(map.name));
  auto end = std::back_inserter(out);
  const auto node = [&](const std::string& name, CellAt cell, const std::string& look) {
    fmt::format_to(end, "  {} [{}, pos=\"{},{}!\"]\n", name, look, cell.x * 0.5,
                   (map.height - 1 - cell.y) * 0.5);
  };
  const auto name_of = [](Behind kind, int id) {
    return fmt::format("{}{}", kind == Behind::station ? 's' : 'j', id);
  };
  for (int id = 0; const grid::GraphStation& station : graph.stations) {
    ++id;
    const std::string label =
        station.name.empty() ? std::to_string(id) : fmt::format("{} {}", id, station.name);
    node(name_of(Behind::station, id), station.cell, fmt::format("shape=circle, label={}", quoted(label)));
  }
  for (int id = 0; const grid::GraphJunction& junction : graph.junctions) {
    ++id;
    node(name_of(Behind::junction, id), junction.cell, fmt::format("shape=box, label=\"j{}\"", id));
  }
  for (std::size_t i = 0; i < graph.unreachable.size(); ++i)
    node(fmt::format("u{}", i + 1), graph.unreachable[i], "shape=circle, style=dashed, label=\"?\"");
  int obstacles = 0;
  for_each_line(graph, [&](const End& from, const Arm& arm) {
    std::string to = name_of(arm.behind, arm.id);
    if (arm.behind == Behind::blocked) {
      to = fmt::format("x{}", ++obstacles);
      node(to, arm.obstacle, "shape=plain, label=\"x\"");
    }
    fmt::format_to(end, "  {} -- {} [label=\"{}\"]\n", name_of(from.kind, from.id), to, arm.length);
  });
  out += "}\n";
  return out;
}

}  // namespace robosim::cli
