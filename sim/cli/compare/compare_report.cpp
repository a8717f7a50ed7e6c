#include "sim/cli/compare/compare_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "sim/wire/json_writer.h"

namespace robosim::cli {
namespace {

using Json = wire::OrderedJson;

double seconds(std::int64_t ns) { return static_cast<double>(ns) * 1e-9; }

std::string place_of(const wire::SourceLine& source) {
  if (source.file.empty()) return "";
  const std::string place = fmt::format("{}:{}", source.file, source.line);
  return source.function.empty() ? place : fmt::format("{} in {}()", place, source.function);
}

std::string names_of(const std::vector<ComparedRun>& runs) {
  std::vector<std::string> names;
  for (const ComparedRun& run : runs) names.push_back(run.inputs.target);
  std::string text = names[0];
  for (std::size_t i = 1; i < names.size(); ++i) text += (i + 1 < names.size() ? ", " : " and ") + names[i];
  return text;
}

std::string uses_text(const char* what, const std::vector<analysis::PinUse>& uses) {
  std::string text;
  for (const analysis::PinUse& use : uses)
    text += fmt::format("    {}  {:<4} {:<22} {:9.4f} s  {}\n", what, use.pin, use.value, seconds(use.t_ns),
                        place_of(use.source));
  return text;
}

std::string side_text(const ComparedSide& side) {
  std::string text = fmt::format("  {:<6} {}\n", side.target, side.text);
  if (const std::string place = place_of(side.source); !place.empty())
    text += fmt::format("         {}\n", place);
  return text;
}

std::string around_text(const ComparedSide& side) {
  std::string text = fmt::format("\naround it on {}, until {:.4f} s:\n", side.target, seconds(side.t_ns));
  text += uses_text("read ", side.reads);
  text += uses_text("drove", side.writes);
  for (const std::string& line : side.said) text += fmt::format("    said   {}\n", line);
  return text;
}

std::string finding_text(const ComparedSide& side) {
  if (!side.finding) return "";
  const wire::Crash& fault = side.finding->fault;
  const std::string place = place_of(fault.where);
  return fmt::format("checks    {}{}{} (on {}, built with --sanitize, at {:.2f} s)\n", fault.reason,
                     place.empty() ? "" : ", ", place, side.target, side.finding->time_s);
}

Json json_of(const wire::SourceLine& source) {
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

Json json_of(const ComparedSide& side) {
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

std::string edge_text(const Edge& edge, const ComparedSide& other) {
  return fmt::format(
      "on the edge: {} {}, too, {}where its clock is {:g} % {}{}; at {:.4f} s, {}\n"
      "  as above  {}\n  so        {}\n",
      edge.target, edge.does_as_other ? "does as " + other.target : "differs from itself",
      edge.as_other ? fmt::format("with {} of {} clocks, as ", edge.as_other, edge.clocks) : "",
      std::abs(edge.ppm) * 1e-4, edge.ppm > 0 ? "fast" : "slow",
      edge.from_ns > 0 ? fmt::format(" from {:.2f} s on", seconds(edge.from_ns)) : "",
      seconds(edge.itself.t_ns[0]), edge.itself.what, edge.itself.sides[0], edge.itself.sides[1]);
}

Json json_of(const Edge& edge) {
  Json json{{"target", edge.target},           {"ppm", edge.ppm},
            {"from_s", seconds(edge.from_ns)}, {"kind", analysis::name_of(edge.itself.kind)},
            {"what", edge.itself.what},        {"t_s", seconds(edge.itself.t_ns[0])},
            {"texts", edge.itself.sides}};
  if (edge.clocks) json.update({{"clocks", edge.clocks}, {"as_other", edge.as_other}});
  return json;
}

}  // namespace

std::string compare_text(const Compared& c) {
  const RunInputs& in = c.runs.front().inputs;
  std::string text = fmt::format("{} on {}, seed {}: {} ", in.sketch, in.map, c.seed, names_of(c.runs));
  text += !c.difference     ? "do the same\n"
          : c.edges.empty() ? "differ\n"
                            : "differ no more than each from itself\n";
  std::size_t longest = 0;
  for (const ComparedRun& run : c.runs) longest = std::max(longest, run.inputs.robot.size());
  for (const ComparedRun& run : c.runs)
    text += fmt::format("  {:<6} {:<{}}  {:<8} {:8.2f} s\n", run.inputs.target, run.inputs.robot, longest,
                        run.result.verdict, run.result.time_s);
  for (std::size_t i = 0; i < c.known.size(); ++i)
    text +=
        fmt::format("known, and not counted: {} ({} “{}”, {} “{}”)\n", c.known[i].what, c.known_targets[i][0],
                    c.known[i].sides[0], c.known_targets[i][1], c.known[i].sides[1]);
  if (!c.difference) return text;
  const analysis::Difference& d = *c.difference;
  text += fmt::format("\nfirst difference, at {:.4f} s on {} and {:.4f} s on {}: {}\n", seconds(d.t_ns[0]),
                      c.sides[0].target, seconds(d.t_ns[1]), c.sides[1].target, d.what);
  for (const ComparedSide& side : c.sides) text += side_text(side);
  for (std::size_t side = 0; side < c.edges.size(); ++side)
    text += edge_text(c.edges[side], c.sides[1 - side]);
  if (!d.cause.empty()) text += fmt::format("cause     {}\n", d.cause);
  for (const ComparedSide& side : c.sides) text += finding_text(side);
  for (const ComparedSide& side : c.sides) text += around_text(side);
  return text;
}

std::string compare_json(const Compared& c) {
  const RunInputs& in = c.runs.front().inputs;
  Json json{{"schema", "robosim.compare/1"},
            {"same", c.same()},
            {"sketch", in.sketch},
            {"map", in.map},
            {"seed", c.seed}};
  Json runs = Json::array();
  for (const ComparedRun& run : c.runs)
    runs.push_back({{"target", run.inputs.target},
                    {"robot", run.inputs.robot},
                    {"verdict", run.result.verdict},
                    {"time_s", run.result.time_s},
                    {"compiler", run.inputs.compiler},
                    {"image_sha256", run.result.image_sha256},
                    {"trace_hash", run.result.trace_hash}});
  json["runs"] = std::move(runs);
  Json known = Json::array();
  for (std::size_t i = 0; i < c.known.size(); ++i)
    known.push_back(
        {{"what", c.known[i].what}, {"targets", c.known_targets[i]}, {"texts", c.known[i].sides}});
  json["known"] = std::move(known);
  json["difference"] = nullptr;
  if (c.difference) {
    json["difference"] = {{"kind", analysis::name_of(c.difference->kind)},
                          {"what", c.difference->what},
                          {"cause", c.difference->cause},
                          {"sides", Json::array({json_of(c.sides[0]), json_of(c.sides[1])})}};
  }
  json["edges"] = Json::array();
  for (const Edge& edge : c.edges) json["edges"].push_back(json_of(edge));
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace robosim::cli
