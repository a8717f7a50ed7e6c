// Tests invalid calibration logs and stopwatch files. Each error must cause one message, which contains the
// file's name and usually the line number.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/file.h"
#include "sim/campaign/calibrate/calibrate.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/calibrate/bench_logs.h"

namespace robosim::calibrate {
namespace bad_logs_test {

using bench::counted_sweep;
using bench::drive;
using bench::Eye;
using bench::sweep;
using ::testing::HasSubstr;

class Folder : public test::TemporaryFolder {
 public:
  std::string write(const std::string& name, const std::string& text) const {
    write_file(path() / name, text);
    return (path() / name);
  }
};

/// Returns the error message for these logs, or "" if they are valid.
std::string answer(const std::vector<std::string>& logs, double tape_m = 0.019,
                   const std::string& stopwatch = "", std::string robot = bench::kRobot) {
  const Folder folder;
  Task task;
  task.robot = folder.write("robot.toml", robot);
  task.tape_m = tape_m;
  int number = 0;
  for (const std::string& log : logs)
    task.logs.push_back(folder.write(fmt::format("log{}.csv", ++number), log));
  if (!stopwatch.empty()) task.stopwatch = folder.write("watch.toml", stopwatch);
  try {
    calibrate(task);
    return "";
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.find('\n'), text.npos) << text;
    const std::size_t slash = text.find("/log") == text.npos ? text.find("/watch") : text.find("/log");
    return slash == text.npos ? text : text.substr(slash + 1);
  }
}

struct Case {
  const char* what;
  std::string log;
  const char* sentence;
};

std::string with_row(const std::string& row) { return "t_us,S1\n0,100\n5000,100\n" + row + "\n"; }

TEST(BadLogs, AreAnsweredWithPlaceAndReason) {
  const Case cases[] = {
      {"empty", "", "log1.csv: the log is empty"},
      {"blank", "\n\n  \n", "log1.csv: the log is empty"},
      {"binary", std::string("t_us,S1\n0,1\0", 12),
       "log1.csv:2: not a log: expected text, as CalibrationLogger prints it, got a byte 0x00"},
      {"old line ends", "t_us,S1\r0,1\r",
       "log1.csv:1: not a log: expected text, as CalibrationLogger prints it, got a byte 0x0D"},
      {"no header", "0,100\n5000,100\n",
       "log1.csv:1: a row before the column names: expected a first row that begins with t_us, got “0”"},
      {"only remarks", "# a\n# b\n", "log1.csv: the log has no table"},
      {"unknown sensor", sweep({}, "S2"), "log1.csv:1: there is no floor sensor “S2”; did you mean S1?"},
      {"a column twice", "t_us,S1,S1\n", "log1.csv:1: the column S1 is given twice"},
      {"a column without a name", "t_us,,S1\n", "log1.csv:1: a column without a name"},
      {"no sensor", "t_us\n", "log1.csv:1: a sweep without a sensor"},
      {"left alone", "t_us,left,count_left,count_right\n", "log1.csv:1: the column right is missing"},
      {"one encoder", "t_us,count_left,S1\n", "log1.csv:1: the column count_right is missing"},
      {"no counts", "t_us,left,right\n",
       "log1.csv:1: a drive requires the columns count_left and count_right"},
      {"text", with_row("10000,abc"), "log1.csv:4: S1: expected a number, got “abc”"},
      {"nothing", with_row("10000,"), "log1.csv:4: S1: expected a number, got “”"},
      {"NaN", with_row("10000,nan"), "log1.csv:4: S1: expected a finite number, got nan"},
      {"infinite", with_row("10000,inf"), "log1.csv:4: S1: expected a finite number, got inf"},
      {"cut off", with_row("10000"),
       "log1.csv:4: expected 2 fields, one for each column name on line 1, got 1"},
      {"too many", with_row("10000,1,2"),
       "log1.csv:4: expected 2 fields, one for each column name on line 1, got 3"},
      {"backwards", with_row("4000,100"),
       "log1.csv:4: t_us: expected a later time than 5000 in the row before, got 4000"},
      {"standing", with_row("5000,100"), "log1.csv:4: t_us: expected a later time"},
      {"before", "t_us,S1\n-5,100\n", "log1.csv:2: t_us: expected a number from 0 to 4.3e9, got -5"},
      {"a quote", with_row("10000,\"1"), "log1.csv:4: a quote is never closed"},
      {"below 0", with_row("10000,-1"),
       "log1.csv:4: S1: expected a reading from 0 to 1023, or of an RC sensor in microseconds, got -1"},
      {"no code", sweep({100, 1400}), "S1: expected a code of analogRead() from 0 to 1023, got "},
      {"one row", "t_us,S1\n0,100\n",
       "log1.csv:1: the sweep is too short: expected at least 100 rows, got 1"},
      {"PWM 300", "t_us,left,right,count_left,count_right\n0,300,0,0,0\n",
       "log1.csv:2: left: expected a whole number from -255 to 255, got 300"},
      {"PWM 1.5", "t_us,left,right,count_left,count_right\n0,1.5,0,0,0\n",
       "log1.csv:2: left: expected a whole number from -255 to 255, got 1.5"},
      {"three counts", "# counts_per_period = 3\n" + sweep(),
       "log1.csv:1: counts_per_period: expected 1, 2 or 4, got “3”"},
      {"no time", "# timing_step_us = x\n" + sweep(),
       "log1.csv:1: timing_step_us: expected a number of microseconds up to 1000, got “x”"},
      {"always the same", sweep({500, 500}),
       "log1.csv:1: S1: expected readings over floor and tape, got nearly the same value"},
      {"beside the tape", sweep({100, 900, 5.45, 5.5}), "log1.csv:1: S1 is over the tape in less than 3 %"},
      {"only half over it", sweep({100, 900, 0.0, 6.0}, "S1", 101),
       "log1.csv:1: S1 never crosses the tape completely"},
      {"white over black", sweep({900, 100}), "log1.csv:1: S1 reads less over the tape than next to it"},
      {"saturated", sweep({100, 1100, 0.5, 6.0, 1023}), "log1.csv:1: S1 reads 1023 in "},
      {"wheels stand still", counted_sweep(0.0),
       "log1.csv:2: the wheels turn too little in this sweep: expected at least a sixth of a turn, got 0 and "
       "0 counts"},
      {"another tape", counted_sweep(800.0), "S1: expected a tape 19.0 mm wide by --tape, got "},
      {"a motor that does not turn", drive(255, 0.0, 3000.0),
       "log1.csv:2: the left motor is driven with 255, but its encoder counts 0: the motor does not turn"},
      {"leads swapped", drive(255, 3000.0, -3000.0),
       "log1.csv:2: the right motor is driven with 255, but its encoder counts -1485: the motor's leads"},
      {"begins with nothing", drive(0, 3000.0, 3000.0),
       "log1.csv:3: left: expected the motor's command in the drive's first row, got 0"},
      {"a drive of an hour", drive(255, 3000.0, 3000.0) + "3600000000,0,0,9000,9000\n",
       "log1.csv:2: the drives are too long: expected at most 120 s together, got 3600 s"},
      {"counts of what", drive(255, 3000.0, 3000.0, ""),
       "log1.csv: the log has counts of edges, but not their number"},
  };
  for (const Case& bad : cases) EXPECT_THAT(answer({bad.log}), HasSubstr(bad.sentence)) << bad.what;
}

TEST(BadLogs, TwoOfDifferentRobotsDisagree) {
  EXPECT_EQ(answer({sweep(), sweep()}), "");
  EXPECT_THAT(answer({sweep(), sweep({400, 900})}),
              HasSubstr("log2.csv:1: in this sweep, S1 reads 1.96 over the floor and 4.41 over the tape, but "
                        "0.496 and 4.41 in the sweep "));
}

TEST(BadLogs, ASweepWantsTheTapesWidth) {
  EXPECT_THAT(answer({sweep()}, 0.0), HasSubstr("log1.csv:1: a sweep over a tape requires the tape's width"));
}

TEST(BadLogs, ADriveWantsEncodersInTheRobotFile) {
  std::string robot = bench::kRobot;
  robot.resize(robot.find("[[part]]\nname = \"encoder_right\""));
  EXPECT_THAT(answer({drive(255, 3000.0, 3000.0)}, 0.019, "", robot),
              HasSubstr("has no encoder on the right wheel"));
}

TEST(BadLogs, AreNotReadWhereTheyAreNot) {
  const Folder folder;
  Task task;
  task.robot = folder.write("robot.toml", bench::kRobot);
  task.logs = {"/nowhere/log.csv"};
  EXPECT_THROW(calibrate(task), InputError);
}

TEST(BadStopwatchFiles, AreAnsweredWithPlaceAndReason) {
  const auto watch = [](const std::string& text) { return answer({}, 0.0, text); };
  EXPECT_THAT(watch("supply = \"7 V\"\n"), HasSubstr("watch.toml: [[drive]] is missing"));
  EXPECT_THAT(watch("[[drive]]\npwm = 0\n"),
              HasSubstr("watch.toml:2:7: pwm: expected a whole number from 1 to 255, got 0"));
  EXPECT_THAT(watch("[[drive]]\npwm = 255\ntime = \"1 s\"\n"), HasSubstr("watch.toml:1:1: [[drive]] "));
  EXPECT_THAT(watch("[[drive]]\npwm = 255\ntime = \"1 m\"\ndistance = \"1 m\"\n"),
              HasSubstr("watch.toml:3:8: time"));
  EXPECT_THAT(watch("[[drive]]\npwm = 255\ntime = \"1 s\"\ndistance = \"1 m\"\nspeed = 3\n"),
              HasSubstr("watch.toml:5"));
}

TEST(Logs, BeginWhereTheBoardBeganLast) {
  // A board resets when the serial monitor opens its port, so its output starts again. Arduino's monitor can
  // also print a time before each line.
  const std::string start = "# robosim calibration log\n";
  EXPECT_EQ(answer({start + "t_us,S1\n0,1\n50" + "\n" + start + sweep()}), "");
  std::string stamped;
  for (const char c : sweep())
    stamped += (stamped.empty() || stamped.back() == '\n' ? "12:00:01.123 -> " : "") + std::string(1, c);
  EXPECT_EQ(answer({stamped}), "");
}

}  // namespace bad_logs_test
}  // namespace robosim::calibrate
