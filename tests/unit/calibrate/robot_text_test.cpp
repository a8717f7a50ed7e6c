// Tests that inserting parameters into a robot file leaves the rest of its text unchanged.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/config.h"
#include "sim/campaign/calibrate/robot_text.h"

namespace robosim::calibrate {
namespace robot_text_test {

Figure figure(const char* table, const char* key, double value, double sd, bool of_part = false) {
  Figure figure;
  figure.table = table;
  figure.of_part = of_part;
  figure.key = key;
  figure.found = {{value, sd}};
  figure.unit = "V";
  figure.most = 1e3;
  return figure;
}

const std::vector<Figure> kFigures{figure("S", "white_volts", 0.512, 0.005, true),
                                   figure("motors", "supply", 7.4, 0.05),
                                   figure("motors", "voltage", 6.0, 0.1)};

TEST(RobotText, KeepsCommentsLayoutAndWhatItDoesNotKnow) {
  EXPECT_EQ(with_figures(R"(# Möhre, my robot
[mine]   # not Robosim's
x = [ 1,
  2 ]
[motors]
voltage   = "6 V"     # of the sheet
gear = 48 # last

[[part]]
  name = "S"
  white_volts = [ "0.4 V", # one }
     { value = "0.5 V", spread = "5 %" } ]   # two
[[part]]
name = "T"
white_volts = "1 V")",
                         "robot.toml", kFigures),
            R"(# Möhre, my robot
[mine]   # not Robosim's
x = [ 1,
  2 ]
[motors]
voltage   = { value = "6.00 V", spread = "0.20 V" }     # of the sheet
gear = 48 # last
supply = { value = "7.40 V", spread = "0.10 V" }

[[part]]
  name = "S"
  white_volts = { value = "0.512 V", spread = "0.010 V" }   # two
[[part]]
name = "T"
white_volts = "1 V")");
}

TEST(RobotText, AddsWhatIsTheBasesAtTheEnd) {
  EXPECT_EQ(with_figures("base = \"uno5\"", "robot.toml", kFigures), R"(base = "uno5"

[[part]]
name = "S"
white_volts = { value = "0.512 V", spread = "0.010 V" }

[motors]
supply = { value = "7.40 V", spread = "0.10 V" }
voltage = { value = "6.00 V", spread = "0.20 V" }
)");
}

TEST(RobotText, KeepsTheLineEndsOfWindows) {
  const std::string text =
      with_figures("[motors]\r\nvoltage = \"6 V\" # a\r\nx = 1\r\n", "robot.toml", kFigures);
  EXPECT_EQ(
      text,
      "[motors]\r\nvoltage = { value = \"6.00 V\", spread = \"0.20 V\" } # a\r\nx = 1\r\n"
      "supply = { value = \"7.40 V\", spread = \"0.10 V\" }\r\n"
      "\r\n[[part]]\r\nname = \"S\"\r\nwhite_volts = { value = \"0.512 V\", spread = \"0.010 V\" }\r\n");
}

TEST(RobotText, RefusesTablesThatHaveNoLines) {
  EXPECT_THROW(with_figures("motors = { voltage = \"6 V\" }", "robot.toml", kFigures), InputError);
  EXPECT_THROW(with_figures("motors.voltage = \"6 V\"", "robot.toml", kFigures), InputError);
}

TEST(RobotText, WritesASpreadThatStaysWithinWhatIsAllowed) {
  Figure low = figure("motors", "no_load_current", 0.010, 0.02);
  EXPECT_EQ(toml_value(low), "{ value = \"0.010 V\", spread = \"0.010 V\" }");
  low.found = {{-0.01, 0.02}};
  EXPECT_EQ(toml_value(low), "{ value = \"0.015 V\", spread = \"0.015 V\" }");
  low.of = {"A", "B"};
  low.found = {{0.4, 0.02}, {0.5, 0.02}};
  EXPECT_EQ(toml_value(low),
            "[\n  { value = \"0.400 V\", spread = \"0.040 V\" },  # A\n  { value = \"0.500 V\", spread = "
            "\"0.040 V\" },  # B\n]");
}

}  // namespace robot_text_test
}  // namespace robosim::calibrate
