#include "sim/cli/compare/compare_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "sim/wire/json_writer.h"

namespace robosim::cli {
namespace {

using Json = wire::OrderedJson;

double seconds(std::int64_t ns) { return static_cast<double>(ns) * 1e-9; }

std::string place_of(const result::SourceLine& source) {
  if (source.file.empty()) return "";
  const std::string place = fmt::format("{}:{}", source.file, source.line);
  return source.function.empty() ? place : fmt::format("{} in {}()", place, source.function);
}

std::string names_of(const campaign::Compared& c) {
  std::string text;
  for (std::size_t i = 0; i < c.target_runs.size(); ++i)
    text += (i == 0 ? "" : i + 1 < c.target_runs.size() ? ", " : " and ") + c.target_runs[i].target;
  return text;
}

/// Returns a line for each robot on each target.
std::string lanes_text(const campaign::Compared& c) {
  const auto robot_of = [&](const campaign::ComparedRun& run) {
    return c.moves.empty() ? run.inputs.robot : fmt::format("{}, {}", run.inputs.robot, run.inputs.target);
  };
  std::size_t name = 0, robot = 0;
  for (const campaign::ComparedTarget& target_run : c.target_runs)
    for (const campaign::ComparedRun& run : target_run.robots) {
      name = std::max(name, run.name.size());
      robot = std::max(robot, robot_of(run).size());
    }
  std::string text;
  for (const campaign::ComparedTarget& target_run : c.target_runs)
    for (const campaign::ComparedRun& run : target_run.robots)
      text += fmt::format("  {:<6} {:<{}}{}{:<{}}  {:<8} {:8.2f} s\n", target_run.target, run.name, name,
                          name ? "  " : "", robot_of(run), robot, run.result.verdict, run.result.time_s);
  return text;
}

std::string uses_text(const char* what, const std::vector<analysis::PinUse>& uses) {
  std::string text;
  for (const analysis::PinUse& use : uses)
    text += fmt::format("    {}  {:<4} {:<22} {:9.4f} s  {}\n", what, use.pin, use.value, seconds(use.t_ns),
                        place_of(use.source));
  return text;
}

std::string side_text(const campaign::ComparedSide& side) {
  std::string text = fmt::format("  {:<6} {}\n", side.target, side.text);
  if (const std::string place = place_of(side.source); !place.empty())
    text += fmt::format("         {}\n", place);
  return text;
}

std::string around_text(const campaign::ComparedSide& side) {
  std::string text = fmt::format("\naround it on {}, until {:.4f} s:\n", side.target, seconds(side.t_ns));
  text += uses_text("read ", side.reads);
  text += uses_text("drove", side.writes);
  for (const std::string& line : side.said) text += fmt::format("    said   {}\n", line);
  return text;
}

std::string finding_text(const campaign::ComparedSide& side) {
  if (!side.finding) return "";
  const result::Crash& fault = side.finding->fault;
  const std::string place = place_of(fault.where);
  return fmt::format("checks    {}{}{} (on {}, built with --sanitize, at {:.2f} s)\n", fault.reason,
                     place.empty() ? "" : ", ", place, side.target, side.finding->time_s);
}

Json json_of(const result::SourceLine& source) {
  if (source.file.empty()) return nullptr;
  return wire::to_json(source);
}

Json json_of(const std::vector<analysis::PinUse>& uses) {
  Json all = Json::array();
  for (const analysis::PinUse& use : uses)
    all.push_back({{"t_s", seconds(use.t_ns)},
                   {"pin", use.pin},
                   {"value", use.value},
                   {"source", json_of(use.source)}});
  return all;
}

Json json_of(const campaign::ComparedSide& side) {
  Json json{{"target", side.target},
            {"t_s", seconds(side.t_ns)},
            {"text", side.text},
            {"source", json_of(side.source)},
            {"reads", json_of(side.reads)},
            {"drives", json_of(side.writes)},
            {"said", side.said}};
  if (side.finding) json["finding"] = wire::to_json(*side.finding);
  return json;
}

Json json_of(const campaign::ComparedRun& run) {
  return {{"target", run.inputs.target},        {"robot", run.inputs.robot},
          {"verdict", run.result.verdict},      {"time_s", run.result.time_s},
          {"compiler", run.inputs.compiler},    {"image_sha256", run.result.image_sha256},
          {"trace_hash", run.result.trace_hash}};
}

Json json_of(const campaign::ComparedTarget& target_run) {
  if (target_run.robots.front().name.empty()) return json_of(target_run.robots.front());
  Json robots = Json::array();
  for (const campaign::ComparedRun& run : target_run.robots) {
    robots.push_back({{"name", run.name}, {"sketch", run.inputs.sketch}});
    robots.back().update(json_of(run));
  }
  return {{"target", target_run.target}, {"robots", std::move(robots)}};
}

/// Describes the last delay of the sketch on the host: "where it is 0.26 ms later from 3.90 s on".
std::string late_text(const std::vector<result::Lateness>& late) {
  if (late.empty()) return "as it is";
  const double ms = 1e-6 * static_cast<double>(late.back().by_ns), from_s = seconds(late.back().from_ns);
  if (late.back().from_ns == 0 && ms < 0.0)
    return fmt::format("where its first delay() ends {:g} ms sooner", -ms);
  if (late.back().from_ns == 0) return fmt::format("where its setup() begins {:g} ms later", ms);
  return fmt::format("where it is {:g} ms {} from {:.2f} s on", std::fabs(ms), ms < 0.0 ? "sooner" : "later",
                     from_s);
}

std::string tick_text(const campaign::Edge& edge, const std::array<campaign::ComparedSide, 2>& sides) {
  std::string ways;
  for (std::size_t side = 0; side < 2; ++side)
    if (sides[side].target != edge.target)
      ways += fmt::format("{} like {}, {}", ways.empty() ? "" : ", and", sides[side].target,
                          late_text(edge.late[side]));
  std::string text =
      fmt::format("on the edge of a tick: {} behaves{}; {}\n", edge.target, ways, edge.itself.what);
  for (std::size_t side = 0; side < 2; ++side)
    text += fmt::format("  {:<9} {}\n", sides[side].target == edge.target ? "as above" : "so",
                        edge.itself.sides[side]);
  return text;
}

std::string edge_text(const campaign::Edge& edge, const campaign::ComparedSide& other) {
  return fmt::format(
      "on the edge: {} also {}, {}where its clock is {:g} % {}{}; at {:.4f} s, {}\n"
      "  as above  {}\n  so        {}\n",
      edge.target, edge.does_as_other ? "behaves like " + other.target : "differs from itself",
      edge.as_other ? fmt::format("with {} of {} clocks, for example ", edge.as_other, edge.clocks) : "",
      std::abs(edge.ppm) * 1e-4, edge.ppm > 0 ? "fast" : "slow",
      edge.from_ns > 0 ? fmt::format(" from {:.2f} s on", seconds(edge.from_ns)) : "",
      seconds(edge.itself.t_ns[0]), edge.itself.what, edge.itself.sides[0], edge.itself.sides[1]);
}

std::string lacks_text(const campaign::Compared& c) {
  if (c.lacks.empty()) return "";
  std::string what;
  for (const result::Lack& lack : c.lacks) {
    const std::string place = place_of(lack.where);
    what += fmt::format("{}{}{}", what.empty() ? "" : "; ", lack.what, place.empty() ? "" : " in " + place);
  }
  return fmt::format(
      "lacks     {} does not have {}. This difference therefore shows nothing about the sketch: run it on "
      "the chip with --target avr\n",
      c.lacking, what);
}

Json json_of(const campaign::Edge& edge) {
  Json json{{"target", edge.target},           {"ppm", edge.ppm},
            {"from_s", seconds(edge.from_ns)}, {"kind", analysis::name_of(edge.itself.kind)},
            {"what", edge.itself.what},        {"t_s", seconds(edge.itself.t_ns[0])},
            {"texts", edge.itself.sides}};
  if (edge.clocks) json.update({{"clocks", edge.clocks}, {"as_other", edge.as_other}});
  if (!edge.is_of_tick()) return json;
  for (const std::vector<result::Lateness>& late : edge.late) {
    Json all = Json::array();
    for (const result::Lateness& one : late)
      all.push_back({{"from_s", seconds(one.from_ns)}, {"by_s", seconds(one.by_ns)}});
    json["late"].push_back(std::move(all));
  }
  return json;
}

}  // namespace

std::string compare_text(const campaign::Compared& c) {
  const launch::RunInputs& in = c.target_runs.front().robots.front().inputs;
  std::string text =
      fmt::format("{} on {}, seed {}{}: {} ", c.sketch, in.map, c.seed,
                  c.moves.empty() ? "" : fmt::format(", {} on each target", c.moves), names_of(c));
  text += !c.difference      ? "do the same\n"
          : !c.lacks.empty() ? fmt::format("differ, but {} lacks a feature that the sketch uses\n", c.lacking)
          : c.edges.empty()  ? "differ\n"
                             : "differ only as much as runs of one target with slightly wrong clocks\n";
  text += lanes_text(c);
  for (const campaign::ComparedKnown& known : c.known)
    text += fmt::format("known difference, not counted: {}{} ({} “{}”, {} “{}”)\n", known.difference.what,
                        known.robot.empty() ? "" : " of robot " + known.robot, known.targets[0],
                        known.difference.sides[0], known.targets[1], known.difference.sides[1]);
  if (!c.difference) return text;
  const analysis::Difference& d = *c.difference;
  text += fmt::format("\nfirst difference,{} at {:.4f} s on {} and {:.4f} s on {}: {}\n",
                      c.robot.empty() ? "" : fmt::format(" of robot {},", c.robot), seconds(d.t_ns[0]),
                      c.sides[0].target, seconds(d.t_ns[1]), c.sides[1].target, d.what);
  for (const campaign::ComparedSide& side : c.sides) text += side_text(side);
  text += lacks_text(c);
  for (std::size_t side = 0; side < c.edges.size(); ++side)
    text += c.edges[side].is_of_tick() ? tick_text(c.edges[side], c.sides)
                                       : edge_text(c.edges[side], c.sides[1 - side]);
  if (!d.cause.empty()) text += fmt::format("cause     {}\n", d.cause);
  for (const campaign::ComparedSide& side : c.sides) text += finding_text(side);
  for (const campaign::ComparedSide& side : c.sides) text += around_text(side);
  return text;
}

std::string compare_json(const campaign::Compared& c) {
  Json json{{"schema", "robosim.compare/1"},
            {"same", c.same()},
            {"sketch", c.sketch},
            {"map", c.target_runs.front().robots.front().inputs.map},
            {"seed", c.seed}};
  json["runs"] = Json::array();
  for (const campaign::ComparedTarget& target_run : c.target_runs)
    json["runs"].push_back(json_of(target_run));
  json["known"] = Json::array();
  for (const campaign::ComparedKnown& known : c.known) {
    Json one{{"what", known.difference.what}, {"targets", known.targets}, {"texts", known.difference.sides}};
    if (!known.robot.empty()) one["robot"] = known.robot;
    json["known"].push_back(std::move(one));
  }
  json["difference"] = nullptr;
  if (c.difference) {
    json["difference"] = {{"kind", analysis::name_of(c.difference->kind)},
                          {"what", c.difference->what},
                          {"cause", c.difference->cause},
                          {"sides", Json::array({json_of(c.sides[0]), json_of(c.sides[1])})}};
    if (!c.robot.empty()) json["difference"]["robot"] = c.robot;
  }
  json["lacks"] = Json::array();
  for (const result::Lack& lack : c.lacks) {
    json["lacks"].push_back(wire::to_json(lack));
    json["lacks"].back()["target"] = c.lacking;
  }
  json["edges"] = Json::array();
  for (const campaign::Edge& edge : c.edges) json["edges"].push_back(json_of(edge));
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace robosim::cli
