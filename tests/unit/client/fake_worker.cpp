// A runner that does what a request's "image" says: the pool's stand-in for robosim-host.
//   die          ends itself
//   never        does not answer
//   input        answers with an error of kind "input"
//   slow         says a lot before it answers
//   any other    is the verdict
#include <unistd.h>

#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

using Json = nlohmann::json;

int main() {
  std::cout << R"({"hello": "fake", "protocol": 1, "version": "0.1.0", "target": "host"})" << std::endl;
  for (std::string line; std::getline(std::cin, line);) {
    const Json request = Json::parse(line);
    const Json& id = request["id"];
    const std::string what = request["image"];
    if (what == "die") return 7;
    if (what == "never") ::pause();
    if (what == "input") {
      std::cout << Json{{"id", id}, {"error", {{"kind", "input"}, {"message", "no such map"}}}} << std::endl;
      continue;
    }
    for (int i = 0; what == "slow" && i < 5'000; ++i)
      std::cout << Json{{"id", id}, {"event", "note"}, {"t_ns", i}, {"text", "still here"}} << '\n';
    Json result{{"verdict", what},        {"why", ""},        {"status", 0},        {"time_s", 1},
                {"goal", "tour"},         {"for_s", 600},     {"profile", "ideal"}, {"serial", ""},
                {"trace_hash", "1:"},     {"map_sha256", ""}, {"robot_sha256", ""}, {"image_sha256", ""},
                {"events", Json::array()}};
    result["seed"] = request["seed"];
    result["metrics"] = {{"distance_m", 1},         {"laps_s", Json::array()},   {"cross_track_rms_mm", 0},
                         {"cross_track_max_mm", 0}, {"off_line_s", 0},           {"collisions", 0},
                         {"energy_j", 0},           {"stations", Json::array()}, {"junctions", 0}};
    std::cout << Json{{"id", id}, {"result", result}} << std::endl;
  }
}
