#include "sim/wire/protocol.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace robosim::wire {
namespace protocol_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

template <typename T>
T content(const char* line) {
  return std::get<T>(parse_line(line).content);
}

template <typename T>
T event(const char* line) {
  return std::get<T>(content<Event>(line));
}

std::string refusal(const char* line) {
  try {
    parse_line(line);
  } catch (const RunnerError& error) {
    return error.what();
  }
  return "";
}

TEST(Protocol, HelloSaysProgramAndTarget) {
  const auto hello =
      content<Hello>(R"({"hello": "robosim-host", "protocol": 1, "version": "0.1.0", "target": "host"})");
  EXPECT_EQ(hello.program, "robosim-host");
  EXPECT_EQ(hello.protocol, 1);
  EXPECT_EQ(hello.target, "host");
}

TEST(Protocol, StartedNamesStationsAndReadings) {
  const auto started = event<Started>(
      R"({"id": 2, "event": "started", "start": [13, 2, "W"], "goal": "tour",
          "stations": [{"id": 1, "name": "dock", "x": 2, "y": 3}], "readings": ["S1", "S2"]})");
  EXPECT_EQ(started.x, 13);
  EXPECT_EQ(started.y, 2);
  EXPECT_EQ(started.facing, 'W');
  ASSERT_EQ(started.stations.size(), 1u);
  EXPECT_EQ(started.stations[0].name, "dock");
  EXPECT_EQ(started.stations[0].y, 3);
  EXPECT_THAT(started.readings, ElementsAre("S1", "S2"));
}

TEST(Protocol, SampleKeepsEveryFigure) {
  const auto sample = event<Sample>(
      R"({"id": 2, "event": "sample", "t_us": 10000, "x": 1352.1, "y": 248.9, "yaw": 0.01, "speed_mm_s": 310.0,
          "cross_track": 1.2, "left": 0.6, "right": 0.58, "readings": [0.0, 0.9]})");
  EXPECT_EQ(sample.t_us, 10000);
  EXPECT_EQ(sample.x_mm, 1352.1);
  EXPECT_EQ(sample.y_mm, 248.9);
  EXPECT_EQ(sample.yaw_rad, 0.01);
  EXPECT_EQ(sample.speed_mm_s, 310.0);
  EXPECT_EQ(sample.cross_track_mm, 1.2);
  EXPECT_EQ(sample.left, 0.6);
  EXPECT_EQ(sample.right, 0.58);
  EXPECT_THAT(sample.readings, ElementsAre(0.0, 0.9));
}

TEST(Protocol, PinsOfARobotReadAsTextWhetherTheyAreNumbersOrNames) {
  const auto robot = content<RobotInfo>(
      R"({"id": 1, "robot": {"name": "uno5", "file": "f", "sha256": "s",
          "board": {"name": "uno", "fqbn": "arduino:avr:uno", "macro": "ARDUINO_AVR_UNO"},
          "budget": {"flash_bytes": 30000, "ram_bytes": 0},
          "outline": [[-40, 60.5]], "sensors": [{"name": "S1", "x": 70, "y": 19}],
          "parts": [{"name": "left", "type": "motor", "pins": {"in1": 8, "in2": "A0"}}]}})");
  EXPECT_EQ(robot.board.macro, "ARDUINO_AVR_UNO");
  EXPECT_EQ(robot.budget.flash_bytes, 30000);
  EXPECT_EQ(robot.budget.ram_bytes, 0);
  EXPECT_EQ(robot.outline_mm[0][1], 60.5);
  EXPECT_EQ(robot.sensors[0].x_mm, 70);
  EXPECT_THAT(robot.parts[0].pins, ElementsAre(std::pair<std::string, std::string>("in1", "8"),
                                               std::pair<std::string, std::string>("in2", "A0")));
}

constexpr const char* kResult =
    R"({"id": 2, "result": {"verdict": "crashed", "why": "w", "next": "n", "status": 1, "time_s": 31.4,
        "goal": "laps:3", "for_s": 600, "seed": 18446744073709551615, "profile": "typical",
        "metrics": {"distance_m": 1.5, "laps_s": [9.5, 9.25], "cross_track_rms_mm": 3.5, "cross_track_max_mm": 9,
          "off_line_s": 0.5, "collisions": 2, "energy_j": 4.25, "stations": ["3", "dock"], "junctions": 6},
        "crash": {"reason": "division by zero", "function": "loop", "file": "A.ino", "line": 7},
        "events": [{"t_s": 1.2, "text": "station 2 visited"}], "serial": "Ready\n", "end": {"x": 1.5, "y": 2.5, "yaw": 0.5}, "eeprom_writes": 12,
        "trace_hash": "1:ab",
        "map_sha256": "m", "robot_sha256": "r", "image_sha256": "i"}})";

TEST(Protocol, ResultKeepsEveryKey) {
  const auto r = content<RunResult>(kResult);
  EXPECT_EQ(r.verdict, "crashed");
  EXPECT_EQ(r.status, 1);
  EXPECT_EQ(r.time_s, 31.4);
  EXPECT_EQ(r.for_s, 600);
  EXPECT_EQ(r.seed, 18446744073709551615u);
  EXPECT_THAT(r.metrics.laps_s, ElementsAre(9.5, 9.25));
  EXPECT_EQ(r.metrics.collisions, 2);
  EXPECT_THAT(r.metrics.stations, ElementsAre("3", "dock"));
  EXPECT_EQ(r.metrics.junctions, 6);
  ASSERT_TRUE(r.crash);
  EXPECT_EQ(r.crash->where.function, "loop");
  EXPECT_EQ(r.crash->where.line, 7);
  EXPECT_EQ(r.events[0].text, "station 2 visited");
  EXPECT_EQ(r.image_sha256, "i");
}

TEST(Protocol, AddedKeysAreNoError) {
  EXPECT_EQ(event<Note>(R"({"id": 1, "event": "note", "t_ns": 5, "text": "t", "new": {}})").t_ns, 5);
}

TEST(Protocol, LinesThatAreNotOfTheProtocolAreQuoted) {
  EXPECT_THAT(refusal("Segmentation fault"), HasSubstr("not JSON): “Segmentation fault”"));
  EXPECT_THAT(refusal("[1]"), HasSubstr("“[1]”"));
  EXPECT_THAT(refusal(R"({"id": 1, "event": "smaple"})"), HasSubstr("“smaple”"));
  EXPECT_THAT(refusal(R"({"id": 1, "event": "note", "t_ns": "x", "text": ""})"), HasSubstr("t_ns"));
  EXPECT_THAT(refusal(R"({"id": 1, "event": "note", "t_ns": 1})"),
              HasSubstr("\"text\": missing key; expected a string"));
  EXPECT_THAT(refusal(R"({"id": 1, "event": "started", "start": [1, 2]})"), HasSubstr("start"));
  EXPECT_THAT(refusal(R"({"id": 1, "result": {}})"), HasSubstr("\"result.verdict\": missing key"));
}

TEST(Protocol, ARunRequestHoldsOnlyWhatDiffersFromTheDefault) {
  RunRequest request;
  request.image = "i.so";
  request.map = "m.map";
  request.robot = "uno5";
  EXPECT_EQ(to_line(3, Request(request)),
            R"({"do":"run","for_ns":600000000000,"id":3,"image":"i.so","map":"m.map","profile":"typical",)"
            R"("robot":"uno5","seed":1})"
            "\n");
  request.start = "1,2,E";
  request.goal = "laps:2";
  request.script = "at 1s press start";
  request.script_file = "s.txt";
  request.samples_every_ns = 10'000'000;
  request.pins = request.serial = request.notes = true;
  EXPECT_EQ(to_line(3, Request(request)),
            R"({"do":"run","for_ns":600000000000,"goal":"laps:2","id":3,"image":"i.so","map":"m.map",)"
            R"("profile":"typical","robot":"uno5","samples_every_ns":10000000,"script":"at 1s press start",)"
            R"("script_file":"s.txt","seed":1,"start":"1,2,E","stream":["pin","serial","note"]})"
            "\n");
}

TEST(Protocol, BytesThatAreNotUtf8AreReplacedNotThrown) {
  EXPECT_EQ(to_line(1, Request(DescribeRobot{"\xff.toml"})),
            "{\"do\":\"describe_robot\",\"id\":1,\"robot\":\"\xEF\xBF\xBD.toml\"}\n");
}

}  // namespace protocol_test
}  // namespace robosim::wire
