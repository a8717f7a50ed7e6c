#include "sim/launch/run_json.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

namespace robosim::launch::run_json_test {

using ::testing::ElementsAre;

result::RunResult result() {
  result::RunResult r;
  r.verdict = "reached";
  r.why = "why";
  r.time_s = 31.4;
  r.goal = "laps:3";
  r.for_s = 600.0;
  r.seed = 18446744073709551615u;
  r.profile = "typical";
  r.metrics = {13.25, {10.5, 9.25}, 4.5, 17.0, 0.125, 2, 33.5, {"1", "dock"}, 6};
  r.usage = {{{"D2", "read"}}, {"buzzer"}, {{"start", "HIGH"}}};
  r.serial = "Ready\n";
  r.trace_hash = "1:ab";
  r.map_sha256 = "m";
  r.robot_sha256 = "r";
  r.image_sha256 = "i";
  return r;
}

RunInputs inputs() { return {"0.1.0", "host", "PidFollower", "oval", "uno5", "s", "gcc 12"}; }

TEST(RunJson, HasTheKeysOfTheSchemaInItsOrder) {
  EXPECT_EQ(run_json(inputs(), result(), std::nullopt), R"({
  "schema": "robosim.run/1",
  "verdict": "reached",
  "why": "why",
  "time_s": 31.4,
  "inputs": {
    "robosim": "0.1.0",
    "goal": "laps:3",
    "for_s": 600.0,
    "target": "host",
    "seed": 18446744073709551615,
    "profile": "typical",
    "sketch": "PidFollower",
    "map": "oval",
    "robot": "uno5",
    "sketch_sha256": "s",
    "image_sha256": "i",
    "map_sha256": "m",
    "robot_sha256": "r",
    "compiler": "gcc 12"
  },
  "metrics": {
    "distance_m": 13.25,
    "laps_s": [
      10.5,
      9.25
    ],
    "cross_track_rms_mm": 4.5,
    "cross_track_max_mm": 17.0,
    "off_line_s": 0.125,
    "collisions": 2,
    "energy_j": 33.5,
    "stations": [
      "1",
      "dock"
    ],
    "junctions": 6
  },
  "usage": {
    "unwired": [
      {
        "pin": "D2",
        "how": "read"
      }
    ],
    "unused": [
      "buzzer"
    ],
    "steady": [
      {
        "part": "start",
        "reads": "HIGH"
      }
    ]
  },
  "serial": "Ready\n",
  "trace_hash": "1:ab"
}
)");
}

TEST(RunJson, ACrashStandsBetweenMetricsAndSerial) {
  result::RunResult r = result();
  r.crash = result::Crash{"division by zero", {"loop", "A.ino", 7}};
  const auto json = nlohmann::ordered_json::parse(run_json(inputs(), r, std::nullopt));
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  EXPECT_THAT(keys, ElementsAre("schema", "verdict", "why", "time_s", "inputs", "metrics", "crash", "usage",
                                "serial", "trace_hash"));
  EXPECT_EQ(json["crash"],
            nlohmann::ordered_json::parse(
                R"({"reason": "division by zero", "function": "loop", "file": "A.ino", "line": 7})"));
}

TEST(RunJson, WhatToTryNextFollowsTheReasonWhereThereIsSomething) {
  result::RunResult r = result();
  r.next = "watch it";
  const auto json = nlohmann::ordered_json::parse(run_json(inputs(), r, std::nullopt));
  EXPECT_EQ(std::next(json.begin(), 3).key(), "next");
  EXPECT_EQ(json["next"], "watch it");
}

TEST(RunJson, WallTimeIsThereOnlyWhenAskedFor) {
  EXPECT_EQ(nlohmann::json::parse(run_json(inputs(), result(), 0.25))["host"]["wall_s"], 0.25);
  EXPECT_FALSE(nlohmann::json::parse(run_json(inputs(), result(), std::nullopt)).contains("host"));
}

TEST(RunJson, BytesThatAreNotUtf8AreReplaced) {
  result::RunResult r = result();
  r.serial = "a\xff";
  EXPECT_EQ(nlohmann::json::parse(run_json(inputs(), r, std::nullopt))["serial"], "a\xEF\xBF\xBD");
}

}  // namespace robosim::launch::run_json_test
