#include "sim/cli/files/graph_text.h"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <vector>

#include "sim/base/pluralize.h"
#include "sim/cli/files/json_lines.h"

namespace robosim::cli {
namespace {

using Json = JsonLines::Json;
using map::Arm;
using map::CellAt;
using map::TrueGraph;
using Behind = Arm::Behind;

// One end of a line: a slot of a junction, or a station.
struct End {
  Behind kind;
  int id;
  int slot;
};

// Calls visit(end, arm) once for each line, where `arm` leads from `end` to the other end. Lines at stations
// come first, then all others, in numerical order.
template <typename Visit>
void for_each_line(const TrueGraph& graph, Visit visit) {
  int id = 0;
  for (const map::GraphStation& station : graph.stations) {
    ++id;
    if (station.arm.behind == Behind::nothing) continue;
    if (station.arm.behind != Behind::station || station.arm.id > id)
      visit(End{Behind::station, id, 0}, station.arm);
  }
  id = 0;
  for (const map::GraphJunction& junction : graph.junctions) {
    ++id;
    for (int slot = 0; const Arm& arm : junction.arms) {
      const bool first = arm.id > id || (arm.id == id && arm.slot > slot);
      if (arm.behind == Behind::blocked || (arm.behind == Behind::junction && first))
        visit(End{Behind::junction, id, slot}, arm);
      ++slot;
    }
  }
}

Json place(CellAt cell) { return {cell.x, cell.y}; }

Json slot_json(const Arm& arm) {
  switch (arm.behind) {
    case Behind::station:
      return {{"station", arm.id}};
    case Behind::junction:
      return {{"junction", arm.id}};
    case Behind::blocked:
      return {{"blocked", place(arm.obstacle)}};
    case Behind::nothing:
      break;
  }
  return nullptr;
}

Json end_json(Behind kind, int id, int slot) {
  if (kind == Behind::station) return {{"station", id}};
  return {{"junction", id}, {"slot", slot}};
}

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

// Escapes text for a string of the dot language.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

}  // namespace

std::string graph_text(const map::Map& map, const map::Start& start, const TrueGraph& graph) {
  std::size_t moves = 0;
  for_each_line(graph, [&](const End&, const Arm& arm) { moves += static_cast<std::size_t>(arm.length); });
  std::string out =
      fmt::format("{}: from {},{},{} {}, {}, {} of {}, {}\n", map.name, start.cell.x, start.cell.y,
                  letter(start.facing), pluralize(graph.stations.size(), "station"),
                  pluralize(graph.junctions.size(), "junction"), pluralize(map::line_count(graph), "line"),
                  pluralize(moves, "move"), pluralize(map::cycle_count(graph), "cycle"));
  return out + graph_tables(graph);
}

std::string graph_tables(const TrueGraph& graph) {
  std::string out;
  auto end = std::back_inserter(out);
  const auto at = [](CellAt cell) { return fmt::format("{},{}", cell.x, cell.y); };
  if (!graph.stations.empty()) out += "\nstation   at         leads to (junction.slot), in moves\n";
  for (int id = 0; const map::GraphStation& station : graph.stations) {
    const std::string name = station.name.empty() ? "" : fmt::format("  \"{}\"", station.name);
    fmt::format_to(end, "{:<9} {:<10} {}{}\n", ++id, at(station.cell), arm_text(station.arm), name);
  }
  if (!graph.junctions.empty())
    out += "\njunction  at         slots 0, 1, 2, … lead to (junction.slot), in moves\n";
  for (int id = 0; const map::GraphJunction& junction : graph.junctions) {
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

void add_graph(JsonLines& lines, const TrueGraph& graph) {
  Json stations = Json::array(), junctions = Json::array(), unreachable = Json::array();
  for (int id = 0; const map::GraphStation& station : graph.stations) {
    stations.push_back({{"id", ++id}, {"x", station.cell.x}, {"y", station.cell.y}});
    if (!station.name.empty()) stations.back()["name"] = station.name;
  }
  for (int id = 0; const map::GraphJunction& junction : graph.junctions) {
    Json slots = Json::array();
    for (const Arm& arm : junction.arms) slots.push_back(slot_json(arm));
    junctions.push_back(
        {{"id", ++id}, {"x", junction.cell.x}, {"y", junction.cell.y}, {"slots", std::move(slots)}});
  }
  for (const CellAt cell : graph.unreachable) unreachable.push_back(place(cell));
  lines.add_list("stations", stations);
  lines.add_list("junctions", junctions);
  lines.add_list("unreachable", unreachable);
}

std::string graph_json(const map::Start& start, const TrueGraph& graph) {
  JsonLines lines;
  lines.add("schema", "robosim.graph/1");
  lines.add("start", {start.cell.x, start.cell.y, std::string(1, letter(start.facing))});
  add_graph(lines, graph);
  Json edges = Json::array();
  for_each_line(graph, [&](const End& from, const Arm& arm) {
    Json to = arm.behind == Behind::blocked ? slot_json(arm) : end_json(arm.behind, arm.id, arm.slot);
    edges.push_back(
        {{"from", end_json(from.kind, from.id, from.slot)}, {"to", std::move(to)}, {"length", arm.length}});
  });
  lines.add_list("edges", edges);
  return lines.text();
}

std::string graph_dot(const map::Map& map, const TrueGraph& graph) {
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
  for (int id = 0; const map::GraphStation& station : graph.stations) {
    ++id;
    const std::string label =
        station.name.empty() ? std::to_string(id) : fmt::format("{} {}", id, station.name);
    node(name_of(Behind::station, id), station.cell, fmt::format("shape=circle, label={}", quoted(label)));
  }
  for (int id = 0; const map::GraphJunction& junction : graph.junctions) {
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
