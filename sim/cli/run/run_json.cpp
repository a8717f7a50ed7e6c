#include "sim/cli/run/run_json.h"

#include <nlohmann/json.hpp>

namespace robosim::cli {
namespace {

using Json = nlohmann::ordered_json;

Json object_of(const RunInputs& in, const wire::RunResult& r, const std::optional<Finding>& finding,
               std::optional<double> wall_s) {
  const wire::Metrics& m = r.metrics;
  Json json{{"schema", "robosim.run/1"}, {"verdict", r.verdict}, {"why", r.why}, {"time_s", r.time_s}};
  json["inputs"] = {{"robosim", in.robosim},
                    {"goal", r.goal},
                    {"for_s", r.for_s},
                    {"target", in.target},
                    {"seed", r.seed},
                    {"profile", r.profile},
                    {"sketch", in.sketch},
                    {"map", in.map},
                    {"robot", in.robot},
                    {"sketch_sha256", in.sketch_sha256},
                    {"image_sha256", r.image_sha256},
                    {"map_sha256", r.map_sha256},
                    {"robot_sha256", r.robot_sha256},
                    {"compiler", in.compiler}};
  if (in.sanitize) json["inputs"]["sanitize"] = true;
  json["metrics"] = {{"distance_m", m.distance_m},
                     {"laps_s", m.laps_s},
                     {"cross_track_rms_mm", m.cross_track_rms_mm},
                     {"cross_track_max_mm", m.cross_track_max_mm},
                     {"off_line_s", m.off_line_s},
                     {"collisions", m.collisions},
                     {"energy_j", m.energy_j},
                     {"stations", m.stations},
                     {"junctions", m.junctions}};
  if (r.crash) {
    json["crash"] = {{"reason", r.crash->reason},
                     {"function", r.crash->function},
                     {"file", r.crash->file},
                     {"line", r.crash->line}};
    if (!r.crash->check.empty()) json["crash"]["check"] = r.crash->check;
    if (!r.crash->registers.empty()) {
      Json calls = Json::array();
      for (const wire::Crash::Call& call : r.crash->calls)
        calls.push_back({{"function", call.function}, {"file", call.file}, {"line", call.line}});
      json["crash"]["calls"] = std::move(calls);
      json["crash"]["registers"] = r.crash->registers;
    }
  }
  if (finding) {
    json["finding"] = {{"check", finding->fault.check},       {"reason", finding->fault.reason},
                       {"function", finding->fault.function}, {"file", finding->fault.file},
                       {"line", finding->fault.line},         {"time_s", finding->time_s}};
  }
  if (r.resources) {
    const wire::Resources& used = *r.resources;
    json["resources"] = {{"flash_bytes", used.flash_bytes},
                         {"ram_bytes", used.ram_bytes},
                         {"stack_bytes_max", used.stack_bytes_max},
                         {"interrupt_share", used.interrupt_share},
                         {"cpu_load", used.cpu_load}};
    if (used.loops > 0) {
      json["resources"]["loops"] = used.loops;
      json["resources"]["loop_us_max"] = used.loop_us_max;
      json["resources"]["loop_us_mean"] = used.loop_us_mean;
    }
  }
  json["serial"] = r.serial;
  json["trace_hash"] = r.trace_hash;
  if (wall_s) json["host"] = {{"wall_s", *wall_s}};
  return json;
}

/// A sketch may print any bytes; JSON holds UTF-8 only.
std::string text_of(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

RunInputs inputs_of(const launch::Prepared& run, const std::string& robosim) {
  return {robosim,
          run.target,
          run.sketch.name,
          run.map.name,
          run.robot.name,
          run.image.sketch_sha256,
          run.image.compiler,
          run.wanted.sanitize};
}

std::string run_json(const RunInputs& inputs, const wire::RunResult& result, std::optional<double> wall_s,
                     const std::optional<Finding>& finding) {
  return text_of(object_of(inputs, result, finding, wall_s), 2);
}

std::string run_json_line(const RunInputs& inputs, const wire::RunResult& result) {
  return text_of(object_of(inputs, result, std::nullopt, std::nullopt), -1);
}

}  // namespace robosim::cli
