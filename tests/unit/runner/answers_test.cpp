// Tests converting the results of a simulation to the units and names of the runner protocol.
#include "sim/runner/answers.h"

#include <gmock/gmock.h>

#include "sim/robot/description.h"

namespace robosim::runner::answers_test {

using ::testing::ElementsAre;

run::Sample sample() {
  run::Sample s;
  s.t = 12 * kMillisecond;
  s.pose = {{0.5, 0.25}, {0.0, 1.0}};
  s.speed = 0.3;
  s.cross_track = -0.004;
  s.left = 0.5;
  s.right = -1.0;
  s.readings = {0.25, 1.0};
  s.at_station = "dock";
  return s;
}

TEST(Answers, ABeginningHasCellsAndTheirSideInMillimetres) {
  run::Beginning beginning;
  beginning.start = {{3, 4}, map::Direction::west};
  beginning.goal = judge::parse_goal("laps:2");
  beginning.stations = {{1, "1", {5, 6}}, {2, "dock", {7, 8}}};
  beginning.readings = {"S1", "LED"};
  beginning.width = 30;
  beginning.height = 20;
  beginning.cell_m = 0.05;

  const wire::Started started = to_wire(beginning);

  EXPECT_EQ(std::tuple(started.x, started.y, started.facing), std::tuple(3, 4, 'W'));
  EXPECT_EQ(started.goal, "laps:2");
  ASSERT_EQ(started.stations.size(), 2u);
  EXPECT_EQ(started.stations[1].id, 2);
  EXPECT_EQ(started.stations[1].name, "dock");
  EXPECT_EQ(std::pair(started.stations[1].x, started.stations[1].y), std::pair(7, 8));
  EXPECT_THAT(started.readings, ElementsAre("S1", "LED"));
  EXPECT_EQ(std::pair(started.width, started.height), std::pair(30, 20));
  EXPECT_DOUBLE_EQ(started.cell_mm, 50.0);
}

TEST(Answers, ASampleIsInMicrosecondsMillimetresAndRadians) {
  const wire::Sample s = to_wire(sample());
  EXPECT_EQ(s.t_us, 12'000);
  EXPECT_DOUBLE_EQ(s.x_mm, 500.0);
  EXPECT_DOUBLE_EQ(s.y_mm, 250.0);
  EXPECT_NEAR(s.yaw_rad, 1.5707963, 1e-6) << "heading north";
  EXPECT_DOUBLE_EQ(s.speed_mm_s, 300.0);
  EXPECT_DOUBLE_EQ(s.cross_track_mm, -4.0);
  EXPECT_DOUBLE_EQ(s.left, 0.5);
  EXPECT_DOUBLE_EQ(s.right, -1.0);
  EXPECT_THAT(s.readings, ElementsAre(0.25, 1.0));
  EXPECT_EQ(s.at_station, "dock");
}

TEST(Answers, APauseReportsItsStopConditionAndTheLargestCrossTrackError) {
  run::State state;
  state.t = 7 * kMillisecond;
  state.stop = 2;
  state.worst_cross_track = 0.012;
  state.worst_t = 3 * kMillisecond;
  state.worst_at = {0.1, 0.2};
  state.powered = false;
  state.driven = true;
  state.serial_bytes = 42;
  state.metrics.collisions = 3;

  const wire::Paused paused = to_wire(state, sample());

  EXPECT_EQ(paused.t_ns, 7'000'000);
  EXPECT_EQ(paused.stop, 2);
  EXPECT_DOUBLE_EQ(paused.worst.cross_track_mm, 12.0);
  EXPECT_EQ(paused.worst.t_ns, 3'000'000);
  EXPECT_DOUBLE_EQ(paused.worst.x_mm, 100.0);
  EXPECT_DOUBLE_EQ(paused.worst.y_mm, 200.0);
  EXPECT_FALSE(paused.powered);
  EXPECT_TRUE(paused.driven);
  EXPECT_EQ(paused.serial_bytes, 42u);
  EXPECT_EQ(paused.metrics.collisions, 3);
  EXPECT_FALSE(paused.resources) << "only an emulated chip reports resources";
  EXPECT_EQ(paused.sample.t_us, 12'000);
}

TEST(Answers, AResultHasTheVerdictsNameAndTheExitStatusOfRobosimRun) {
  judge::Outcome outcome;
  outcome.verdict = judge::Verdict::crashed;
  outcome.why = "The sketch crashed.";
  outcome.next = {"Look at line 3.", judge::NextStep::By::watching};
  outcome.goal = judge::parse_goal("tour");
  outcome.time = 1500 * kMillisecond;
  outcome.crash = exec::Crash{"division by zero", {"loop", "A.ino", 7}, {}, "", ""};
  outcome.events = {{250'000'000, 0, result::StationVisited{"2"}}};
  outcome.serial = "hello\n";
  outcome.end = {{0.5, 0.25}, {1.0, 0.0}};
  outcome.eeprom_writes = 9;
  outcome.trace_hash = "1:0123456789abcdef";

  const result::RunResult result = to_wire(outcome);

  EXPECT_EQ(result.verdict, "crashed");
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.why, "The sketch crashed.");
  EXPECT_EQ(result.next, "Look at line 3.");
  EXPECT_EQ(result.next_by, "watching");
  EXPECT_EQ(result.goal, "tour");
  EXPECT_DOUBLE_EQ(result.time_s, 1.5);
  ASSERT_TRUE(result.crash);
  EXPECT_EQ(result.crash->where.line, 7);
  ASSERT_EQ(result.events.size(), 1u);
  EXPECT_DOUBLE_EQ(result.events[0].t_s, 0.25);
  EXPECT_EQ(result.events[0].text, result::text_of(outcome.events[0]));
  EXPECT_EQ(result.serial, "hello\n");
  EXPECT_DOUBLE_EQ(result.end.x_mm, 500.0);
  EXPECT_DOUBLE_EQ(result.end.y_mm, 250.0);
  EXPECT_DOUBLE_EQ(result.end.yaw_rad, 0.0);
  EXPECT_EQ(result.eeprom_writes, 9u);
  EXPECT_EQ(result.trace_hash, "1:0123456789abcdef");
  EXPECT_FALSE(result.resources);
}

TEST(Answers, EveryVerdictHasTheExitStatusOfItsKind) {
  using judge::Verdict;
  const std::pair<Verdict, int> all[] = {
      {Verdict::reached, 0},     {Verdict::lost, 1},         {Verdict::stuck, 1},   {Verdict::toppled, 1},
      {Verdict::hung, 1},        {Verdict::ended, 1},        {Verdict::crashed, 1}, {Verdict::timeout, 4},
      {Verdict::over_budget, 1}, {Verdict::interrupted, 130}};
  for (const auto& [verdict, status] : all) {
    judge::Outcome outcome;
    outcome.verdict = verdict;
    EXPECT_EQ(to_wire(outcome).status, status) << judge::to_string(verdict);
  }
}

TEST(Answers, ARobotHasThePinsOfItsPartsAsItsFileHasThem) {
  const wire::RobotInfo pony = to_wire(robot::describe(robot::load_description("pony")));
  EXPECT_EQ(pony.name, "pony");
  EXPECT_EQ(pony.board.name, "uno");
  EXPECT_EQ(pony.board.fqbn, "arduino:avr:uno");
  ASSERT_FALSE(pony.outline_mm.empty());
  EXPECT_DOUBLE_EQ(pony.outline_mm[0][0], 80.0);
  EXPECT_DOUBLE_EQ(pony.outline_mm[0][1], 45.0);
  std::vector<std::string> pins;
  for (const auto& part : pony.parts)
    for (const auto& [use, pin] : part.pins)
      if (part.name == "REG1" || part.name == "buzzer") pins.push_back(part.name + "." + use + " " + pin);
  EXPECT_THAT(pins, ElementsAre("REG1.data 11", "REG1.clock 13", "REG1.latch 10", "buzzer.pin REG1.Q7"));
}

}  // namespace robosim::runner::answers_test
