#include "sim/view/terminal/live_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/terminal/terminal_looks.h"

namespace robosim::terminal {
namespace live_scene_test {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

wire::RobotInfo robot() {
  wire::RobotInfo info;
  info.sensors = {{"S1", 60, 10}, {"S2", 60, -10}};
  info.outline_mm = {{-20, -40}, {60, -40}, {60, 40}, {-20, 40}};
  return info;
}

wire::Started started() {
  wire::Started event;
  event.goal = "tour";
  event.stations = {{1, "1", 0, 0}, {2, "dock", 9, 0}};
  event.readings = {"S1", "S2"};
  return event;
}

wire::Sample sample(double x_mm, double y_mm, double yaw_rad = 0.0) {
  return {1'230'000, x_mm, y_mm, yaw_rad, 310.0, 0.0, 0.5, -0.25, {0.0, 1.0}};
}

std::string line_of(int columns) { return std::string(static_cast<std::size_t>(columns), '1') + "\n"; }

TEST(LiveScene, ShowsTimeSpeedMotorsSensorsSerialAndNotes) {
  const auto map = map::parse_map(line_of(10), "t.map");
  LiveScene scene("PidFollower · uno5 on oval", map, robot());
  scene.add(started());
  scene.add(sample(450, 50));
  scene.add(wire::SerialText{1, "Ready\nerror 5"});
  scene.add(wire::note_of({2'500'000'000, 0, result::StationVisited{"dock"}}));
  const std::string text = to_text(scene.draw(80, 24, "×1", kPlain), kPlain);
  EXPECT_THAT(text, StartsWith("t 1.23 s  0.31 m/s  ×1  PidFollower · uno5 on oval\n"));
  EXPECT_THAT(text, HasSubstr("left  ▕█████     ▏+0.50  right ▕██▌       ▏-0.25\n"));
  EXPECT_THAT(text, HasSubstr("S1    ▕          ▏  S2    ▕██████████▏\n"));
  EXPECT_THAT(text, HasSubstr("2.50 s  station dock visited\n"));
  EXPECT_THAT(text, HasSubstr("› Ready\n› error 5\n"));
  EXPECT_THAT(text, HasSubstr("→"));
  EXPECT_THAT(text, HasSubstr("q end the run\n"));
}

TEST(LiveScene, ShowsAllOfSeveralRobotsAndWhomANoteIsAbout) {
  const auto map = map::parse_map(line_of(10), "t.map");
  LiveScene scene("2 robots", map, robot(), {"A", "B"});
  scene.add(started());
  scene.add(sample(250, 50));
  wire::Sample other = sample(750, 50, 3.14159);
  other.agent = 1;
  scene.add(other);
  wire::Note note = wire::note_of({2'500'000'000, 1, result::StationVisited{"dock"}});
  scene.add(note);
  wire::SerialText text{1, "of B\n"};
  text.agent = 1;
  scene.add(text);
  const std::string shown = to_text(scene.draw(80, 24, "×1", kPlain), kPlain);
  EXPECT_THAT(shown, HasSubstr("→"));
  EXPECT_THAT(shown, HasSubstr("←"));
  EXPECT_THAT(shown, HasSubstr("2.50 s  B: station dock visited\n"));
  EXPECT_THAT(shown, Not(HasSubstr("of B")));
}

TEST(LiveScene, ShowsGaugesAsNumbersWithTheirUnits) {
  const auto map = map::parse_map(line_of(10), "t.map");
  wire::RobotInfo info = robot();
  info.gauges = {{"pan", "deg"}, {"sonar", "cm"}};
  LiveScene scene("t", map, info);
  wire::Started begin = started();
  begin.readings = {"pan", "LED", "sonar"};
  scene.add(begin);
  wire::Sample now = sample(450, 50);
  now.readings = {132.5, 1.0, 20.71};
  scene.add(now);
  EXPECT_THAT(to_text(scene.draw(80, 24, "×1", kPlain), kPlain),
              HasSubstr("pan 132.5 deg  ● LED  sonar 20.71 cm\n"));
}

TEST(LiveScene, ShowsWhatDisplaysShow) {
  const auto map = map::parse_map(line_of(10), "t.map");
  LiveScene scene("t", map, robot());
  scene.add(started());
  scene.add(sample(450, 50));
  scene.add(wire::note_of({1'000'000'000, 0, result::PartTold{"lcd", "Lap 1"}}));
  scene.add(wire::note_of({2'000'000'000, 0, result::PartTold{"lcd", "Lap 2|12.4 s"}}));
  scene.add(wire::note_of({2'500'000'000, 0, result::StationVisited{"dock"}}));
  const std::string text = to_text(scene.draw(80, 24, "×1", kPlain), kPlain);
  EXPECT_THAT(text, HasSubstr("\nlcd Lap 2|12.4 s\n2.50 s  station dock visited\n"));
}

TEST(LiveScene, WhatIsNoLineSensorIsOnOrOff) {
  const auto map = map::parse_map(line_of(10), "t.map");
  LiveScene scene("t", map, robot());
  wire::Started begin = started();
  begin.readings = {"start", "S2", "LED"};
  scene.add(begin);
  wire::Sample now = sample(450, 50);
  now.readings = {0.0, 0.5, 1.0};
  scene.add(now);
  const std::string text = to_text(scene.draw(80, 24, "", kPlain), kPlain);
  EXPECT_THAT(text, HasSubstr("S2    ▕█████     ▏\n○ start  ● LED\n"));
}

TEST(LiveScene, PlainAsciiWorksToo) {
  const auto map = map::parse_map(line_of(10), "t.map");
  LiveScene scene("t", map, robot());
  scene.add(started());
  scene.add(sample(450, 50));
  const Look ascii{false, false};
  const std::string text = to_text(scene.draw(80, 24, "×1", ascii), ascii);
  EXPECT_THAT(text, HasSubstr("left  [#####     ]+0.50"));
  for (const char c : text) ASSERT_GE(c, 0);
}

TEST(LiveScene, ShowsTheVerdictInsteadOfTheLastNote) {
  const auto map = map::parse_map(line_of(10), "t.map");
  LiveScene scene("t", map, robot());
  scene.add(started());
  scene.add(sample(450, 50));
  scene.add(wire::Note{2'500'000'000, "a note"});
  result::RunResult result;
  result.verdict = "lost";
  result.why = "no sensor saw the line for 1 m";
  scene.finish(result);
  const std::string text = to_text(scene.draw(80, 24, "×1", kPlain), kPlain);
  EXPECT_THAT(text, HasSubstr("lost: no sensor saw the line for 1 m\n"));
  EXPECT_THAT(text, Not(HasSubstr("a note")));
  EXPECT_THAT(text, HasSubstr("press any key"));
}

TEST(LiveScene, TheTrailStaysBehind) {
  const auto map = map::parse_map(line_of(10), "t.map");
  LiveScene scene("t", map, robot());
  scene.draw(80, 24, "", kPlain);
  scene.add(started());
  scene.add(sample(50, 50));
  scene.add(sample(750, 50));
  const Frame frame = scene.draw(80, 24, "", kPlain);
  int trail = 0;
  for (int row = 0; row < frame.rows(); ++row) {
    for (int column = 0; column < frame.columns(); ++column) trail += frame.at(column, row).ink == Ink::trail;
  }
  EXPECT_GT(trail, 20);
}

/// Returns the column of the robot's arrow, or -1 if the arrow is not visible.
int column_of_robot(const Frame& frame) {
  for (int row = 0; row < frame.rows(); ++row) {
    for (int column = 0; column < frame.columns(); ++column) {
      if (frame.at(column, row) == Glyph{U'→', Ink::robot}) return column;
    }
  }
  return -1;
}

TEST(LiveScene, ALargeMapIsFollowed) {
  const auto map = map::parse_map(line_of(400), "t.map");
  LiveScene scene("t", map, robot());
  scene.add(started());
  for (const double x_mm : {50.0, 5'000.0, 20'000.0, 39'950.0}) {
    scene.add(sample(x_mm, 50));
    EXPECT_GE(column_of_robot(scene.draw(80, 24, "", kPlain)), 0) << x_mm;
  }
}

TEST(LiveScene, ArrowsMoveTheWindowAndFComesBack) {
  const auto map = map::parse_map(line_of(400), "t.map");
  LiveScene scene("t", map, robot());
  scene.add(started());
  scene.add(sample(20'000, 50));
  const int before = column_of_robot(scene.draw(80, 24, "", kPlain));
  scene.scroll(1, 0);
  const int after = column_of_robot(scene.draw(80, 24, "", kPlain));
  EXPECT_EQ(after, before - 8);  // the window moved by a tenth of 80 columns
  for (int i = 0; i < 10; ++i) scene.scroll(1, 0);
  EXPECT_EQ(column_of_robot(scene.draw(80, 24, "", kPlain)), -1);
  scene.follow();
  EXPECT_GE(column_of_robot(scene.draw(80, 24, "", kPlain)), 0);
}

TEST(LiveScene, SerialOutputDoesNotResizeTheFloor) {
  const auto map = map::parse_map(line_of(10) + "1________1\n" + line_of(10), "t.map");
  LiveScene scene("t", map, robot());
  scene.add(started());
  scene.add(sample(450, 50));
  const Frame before = scene.draw(80, 24, "", kPlain);
  scene.add(wire::SerialText{1, "a\nb\nc\nd\n"});
  const Frame after = scene.draw(80, 24, "", kPlain);
  EXPECT_EQ(column_of_robot(before), column_of_robot(after));
}

TEST(LiveScene, AnyWindowSizeCanBeDrawn) {
  const auto map = map::parse_map(line_of(30) + line_of(30), "t.map");
  LiveScene scene("t", map, robot());
  scene.add(started());
  scene.add(sample(100, 50));
  for (const int columns : {1, 2, 10, 79, 300}) {
    for (const int rows : {1, 2, 5, 11, 24, 100}) {
      const Frame frame = scene.draw(columns, rows, "×1", kPlain);
      EXPECT_EQ(frame.columns(), columns);
      EXPECT_EQ(frame.rows(), rows);
    }
  }
}

}  // namespace live_scene_test
}  // namespace robosim::terminal
