#include "sim/cli/run/classic_text.h"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "sim/base/pluralize.h"
#include "sim/cli/files/graph_text.h"
#include "sim/cli/files/json_lines.h"

namespace robosim::cli {
namespace {

using Json = JsonLines::Json;
using cells::CellPose;
using cells::Ending;

Json pose_json(const CellPose& pose) {
  return {pose.cell.x, pose.cell.y, std::string(1, letter(pose.facing))};
}

std::string pose_text(const CellPose& pose) {
  return fmt::format("{},{},{}", pose.cell.x, pose.cell.y, letter(pose.facing));
}

const char* name_of(Ending ending) {
  static constexpr const char* kNames[] = {"complete", "lost", "out_of_moves", "no_way", "refused"};
  return kNames[static_cast<int>(ending)];
}

// Describes why the run failed; "" without a failure.
std::string trouble(Ending ending, const std::string& why) {
  switch (ending) {
    case Ending::complete:
      return "";
    case Ending::lost:
      return "the robot is lost: its observations contradict its graph";
    case Ending::out_of_moves:
      return "it has used up its moves";
    case Ending::no_way:
      return "no way exists: an obstacle blocks it";
    case Ending::refused:
      return "the planner refuses: " + why;
  }
  return "";
}

const char* state_of(const cells::Walk& walk) {
  static constexpr const char* kNames[] = {"closed", "out_of_moves", "returned"};
  return kNames[static_cast<int>(walk.ending)];
}

const char* ending_of(const cells::Walk& walk) {
  static constexpr const char* kTexts[] = {", and from here it would repeat the same loop",
                                           ", all that were allowed", ", and it has ended"};
  return kTexts[static_cast<int>(walk.ending)];
}

Json walk_json(const cells::Walk& walk) {
  Json ends = Json::array();
  for (const map::CellAt cell : walk.dead_ends) ends.push_back({cell.x, cell.y});
  return {{"time", number(walk.time)},
          {"moves", walk.moves},
          {"end", pose_json(walk.end)},
          {"state", state_of(walk)},
          {"dead_ends", std::move(ends)}};
}

Json route_json(const cells::Route& route) {
  return {{"from", route.from},
          {"to", route.to},
          {"state", name_of(route.ending)},
          {"junctions", route.junctions},
          {"turns", route.turns},
          {"time", number(route.time)},
          {"end", pose_json(route.end)},
          {"ratio_to_shortest", number(route.ratio_to_shortest)}};
}

Json move_json(const TapedMove& m) {
  Json json = pose_json(m.pose);
  json.insert(json.end(), {cells::name_of(m.sense), cells::name_of(m.move), number(m.clock)});
  return json;
}

std::string move_text(const TapedMove& m) {
  return fmt::format("{:>12}  {:<11} {:<13} {}\n", pose_text(m.pose), cells::name_of(m.sense),
                     cells::name_of(m.move), m.clock);
}

}  // namespace

std::string classic_json(const ClassicReport& r) {
  JsonLines lines;
  lines.add("schema", "robosim.classic/1");
  lines.add("start", pose_json({r.start.cell, r.start.facing}));
  lines.add("algorithm", r.arguments.algorithm);
  lines.add("speed", number(r.arguments.speed));
  if (r.scan) {
    lines.open("scan", {{"time", number(r.scan->time)},
                        {"moves", r.scan->moves},
                        {"end", pose_json(r.scan->end)},
                        {"state", name_of(r.scan->ending)}});
    add_graph(lines, r.scan->graph);
    lines.close();
  }
  if (r.walk) lines.add("walk", walk_json(*r.walk));
  if (!r.arguments.to.empty()) {
    Json routes = Json::array();
    for (const cells::Route& route : r.routes) routes.push_back(route_json(route));
    lines.add_list("routes", routes);
  }
  if (r.arguments.trace) {
    Json moves = Json::array();
    for (const TapedMove& move : r.trace) moves.push_back(move_json(move));
    lines.add_list("trace", moves);
  }
  return lines.text();
}

std::string classic_text(const ClassicReport& r) {
  std::string out;
  auto end = std::back_inserter(out);
  if (r.arguments.trace) {
    out += "        pose  sense       move          clock\n";
    for (const TapedMove& move : r.trace) out += move_text(move);
    out += '\n';
  }
  const std::string from = fmt::format("{} from {}", r.map.name, pose_text({r.start.cell, r.start.facing}));
  if (r.scan) {
    fmt::format_to(end, "{}: scanned in {} s ({}), {}, {}; the robot is at {}\n", from, r.scan->time,
                   pluralize(r.scan->moves, "move"), pluralize(r.scan->graph.stations.size(), "station"),
                   pluralize(r.scan->graph.junctions.size(), "junction"), pose_text(r.scan->end));
    if (const std::string what = trouble(r.scan->ending, ""); !what.empty())
      fmt::format_to(end, "The scan is not complete: {}.\n", what);
    out += graph_tables(r.scan->graph);
  }
  if (r.walk) {
    fmt::format_to(end, "{}: {} in {} s{}; the robot is at {}\n", from, pluralize(r.walk->moves, "move"),
                   r.walk->time, ending_of(*r.walk), pose_text(r.walk->end));
    fmt::format_to(end, "ends of lines visited:");
    for (const map::CellAt cell : r.walk->dead_ends) fmt::format_to(end, " {},{}", cell.x, cell.y);
    out += r.walk->dead_ends.empty() ? " none\n" : "\n";
  }
  if (!r.routes.empty()) out += "\nfrom  to    time      junctions / turns\n";
  for (const cells::Route& route : r.routes) {
    const std::string what = trouble(route.ending, route.why);
    fmt::format_to(end, "{:<5} {:<5} {:<9} {}\n", route.from, route.to, fmt::format("{} s", route.time),
                   !what.empty() ? what
                   : route.junctions.empty()
                       ? std::string("straight there")
                       : fmt::format("{} / {}", fmt::join(route.junctions, "-"), route.turns));
  }
  return out;
}

}  // namespace robosim::cli
