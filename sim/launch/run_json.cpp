#include "sim/launch/run_json.h"

#include "sim/wire/json_writer.h"

namespace robosim::launch {
namespace {

using Json = wire::OrderedJson;

Json object_of(const RunInputs& in, const result::RunResult& r, const std::optional<result::Finding>& finding,
               std::optional<double> wall_s) {
  Json result = wire::to_json(r);
  Json json{{"schema", "robosim.run/1"}};
  const auto take = [&](const char* key) {
    if (result.contains(key)) json[key] = std::move(result[key]);
  };
  for (const char* key : {"verdict", "why"}) take(key);
  if (!r.next.empty()) take("next");
  take("time_s");
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
  take("because");
  take("metrics");
  take("crash");
  if (finding) json["finding"] = wire::to_json(*finding);
  for (const char* key : {"divisions_by_zero", "lacks", "watchdog_resets", "detected", "resources", "usage",
                          "serial", "trace_hash"})
    take(key);
  if (wall_s) json["host"] = {{"wall_s", *wall_s}};
  return json;
}

}  // namespace

RunInputs inputs_of(const Prepared& run, const std::string& robosim) {
  return {robosim,
          run.target,
          run.sketch.name,
          run.map.name,
          run.robot.name,
          run.image.sketch_sha256,
          run.image.compiler,
          run.wanted.sanitize};
}

std::string run_json(const RunInputs& inputs, const result::RunResult& result, std::optional<double> wall_s,
                     const std::optional<result::Finding>& finding) {
  return wire::text_of(object_of(inputs, result, finding, wall_s), 2) + "\n";
}

std::string run_json_line(const RunInputs& inputs, const result::RunResult& result) {
  return wire::text_of(object_of(inputs, result, std::nullopt, std::nullopt)) + "\n";
}

std::string fleet_json(const std::vector<RobotRun>& robots, std::optional<double> wall_s) {
  std::size_t reached = 0;
  Json all = Json::array();
  for (const RobotRun& robot : robots) {
    reached += robot.result.status == 0;
    Json one{{"name", robot.name}};
    one.update(object_of(robot.inputs, robot.result, std::nullopt, std::nullopt));
    one.erase("schema");
    all.push_back(std::move(one));
  }
  Json json{{"schema", "robosim.fleet/1"}, {"reached", reached}, {"robots", std::move(all)}};
  if (wall_s) json["host"] = {{"wall_s", *wall_s}};
  return wire::text_of(json, 2) + "\n";
}

}  // namespace robosim::launch
