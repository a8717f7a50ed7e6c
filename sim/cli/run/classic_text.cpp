#include "sim/cli/run/classic_text.h"

#include <fmt/format.h>

#include <iterator>

#include "sim/base/counted.h"
#include "sim/cli/files/graph_text.h"

namespace robosim::cli {
namespace {

using cells::CellPose;
using cells::Ending;

std::string pose_json(const CellPose& pose) {
  return fmt::format("[{}, {}, \"{}\"]", pose.cell.x, pose.cell.y, letter(pose.facing));
}

std::string pose_text(const CellPose& pose) {
  return fmt::format("{},{},{}", pose.cell.x, pose.cell.y, letter(pose.facing));
}

const char* name_of(Ending ending) {
  static constexpr const char* kNames[] = {"complete", "lost", "out_of_moves", "no_way", "refused"};
  return kNames[static_cast<int>(ending)];
}

// What went wrong, for people; "" if nothing did.
std::string trouble(Ending ending, const std::string& why) {
  switch (ending) {
    case Ending::complete:
      return "";
    case Ending::lost:
      return "the robot is lost: what it met cannot be there";
    case Ending::out_of_moves:
      return "its moves were used up";
    case Ending::no_way:
      return "there is no way: an obstacle is between";
    case Ending::refused:
      return "the planner refuses: " + why;
  }
  return "";
}

std::string scan_json(const cells::Scan& scan) {
  return fmt::format(
      ",\n  \"scan\": {{\n  \"time\": {}, \"moves\": {}, \"end\": {}, \"state\": \"{}\"{}\n  }}", scan.time,
      scan.moves, pose_json(scan.end), name_of(scan.ending), graph_members(scan.graph));
}

const char* state_of(const cells::Walk& walk) {
  static constexpr const char* kNames[] = {"closed", "out_of_moves", "returned"};
  return kNames[static_cast<int>(walk.ending)];
}

const char* ending_of(const cells::Walk& walk) {
  static constexpr const char* kTexts[] = {", and from here it would go the same round again",
                                           ", all that were allowed", ", and it has ended"};
  return kTexts[static_cast<int>(walk.ending)];
}

std::string walk_json(const cells::Walk& walk) {
  std::string cells;
  for (const grid::CellAt cell : walk.dead_ends)
    cells += fmt::format("{}[{}, {}]", cells.empty() ? "" : ", ", cell.x, cell.y);
  return fmt::format(
      ",\n  \"walk\": {{\"time\": {}, \"moves\": {}, \"end\": {}, \"state\": \"{}\", \"dead_ends\": [{}]}}",
      walk.time, walk.moves, pose_json(walk.end), state_of(walk), cells);
}

std::string route_json(const cells::Route& route) {
  return fmt::format(
      "{{\"from\": {}, \"to\": {}, \"state\": \"{}\", \"junctions\": [{}], \"turns\": \"{}\", \"time\": {}, "
      "\"end\": {}, "
      "\"ratio_to_shortest\": {}}}",
      route.from, route.to, name_of(route.ending), fmt::join(route.junctions, ", "), route.turns, route.time,
      pose_json(route.end), route.ratio_to_shortest);
}

std::string move_text(const TapedMove& m) {
  return fmt::format("{:>12}  {:<11} {:<13} {}\n", pose_text(m.pose), cells::name_of(m.sense),
                     cells::name_of(m.move), m.clock);
}

}  // namespace

std::string classic_json(const ClassicReport& r) {
  std::string out = fmt::format(
      "{{\n  \"schema\": \"robosim.classic/1\",\n  \"start\": {},\n  \"algorithm\": \"{}\",\n  \"speed\": {}",
      pose_json({r.start.cell, r.start.facing}), r.arguments.algorithm, r.arguments.speed);
  if (r.scan) out += scan_json(*r.scan);
  if (r.walk) out += walk_json(*r.walk);
  auto end = std::back_inserter(out);
  if (!r.arguments.to.empty()) {
    out += ",\n  \"routes\": [";
    for (std::size_t i = 0; i < r.routes.size(); ++i)
      fmt::format_to(end, "{}\n    {}", i ? "," : "", route_json(r.routes[i]));
    out += "\n  ]";
  }
  if (r.arguments.trace) {
    out += ",\n  \"trace\": [";
    for (std::size_t i = 0; i < r.trace.size(); ++i) {
      const TapedMove& m = r.trace[i];
      fmt::format_to(end, "{}\n    [{}, {}, \"{}\", \"{}\", \"{}\", {}]", i ? "," : "", m.pose.cell.x,
                     m.pose.cell.y, letter(m.pose.facing), cells::name_of(m.sense), cells::name_of(m.move),
                     m.clock);
    }
    out += "\n  ]";
  }
  return out + "\n}\n";
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
                   counted(r.scan->moves, "move"), counted(r.scan->graph.stations.size(), "station"),
                   counted(r.scan->graph.junctions.size(), "junction"), pose_text(r.scan->end));
    if (const std::string what = trouble(r.scan->ending, ""); !what.empty())
      fmt::format_to(end, "The scan is not complete: {}.\n", what);
    out += graph_tables(r.scan->graph);
  }
  if (r.walk) {
    fmt::format_to(end, "{}: {} in {} s{}; the robot is at {}\n", from, counted(r.walk->moves, "move"),
                   r.walk->time, ending_of(*r.walk), pose_text(r.walk->end));
    fmt::format_to(end, "ends of lines visited:");
    for (const grid::CellAt cell : r.walk->dead_ends) fmt::format_to(end, " {},{}", cell.x, cell.y);
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
