// Tests effects of a battery on a sketch, by pairs of runs with a full and a weak battery. Of two ways to
// drive, only one succeeds with the weak battery.
#include <fstream>

#include "tests/support/temporary_folder.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace power_test {

class Power : public testing::Test {
 protected:
  /// Runs TurnsBack on a line of 1.2 m, on an uno5 with these keys of `[battery]`.
  result::RunResult run(const std::string& letter, const std::string& battery, double seconds,
                        const std::string& target = "host") {
    const std::filesystem::path map = folder_.path() / "strip.map", robot = folder_.path() / "fed.toml";
    std::ofstream(map) << "+++\nsize = [\"2 m\", \"600 mm\"]\n[start]\nalong = \"300 mm\"\n[[path]]\n"
                          "from = [\"200 mm\", \"300 mm\"]\nsegments = [{ length = \"1200 mm\" }]\n+++\n";
    std::ofstream(robot) << "base = \"uno5\"\n[battery]\n" << battery;
    wire::RunRequest request = request_of({.sketch = "TurnsBack",
                                           .map = map.string(),
                                           .robot = robot.string(),
                                           .goal = "none",
                                           .script = "at 50ms send \"" + letter + "\"\n",
                                           .seed = 1,
                                           .for_s = seconds,
                                           .target = target});
    request.profile = "ideal";
    return runner_of(target).run(request, {});
  }

 private:
  TemporaryFolder folder_;
};

std::string lithium(const char* charge) {
  return std::string("kind = \"li-ion\"\ncells = 2\ncapacity_mAh = 450\ncharge = ") + charge + "\n";
}

std::string alkaline(const char* charge) {
  return std::string("kind = \"alkaline\"\ncells = 4\ncapacity_mAh = 2000\ncharge = ") + charge + "\n";
}

// By the table in sim/robot/battery.cpp, 54.4 % charge gives 7.4 V at rest, and 4.3 % gives 6.6 V.
TEST_F(Power, OfAnEmptierBatteryMakesATurnByTimeTooShort) {
  const result::RunResult full = run("t", lithium("0.544"), 15.0);
  EXPECT_EQ(full.verdict, "reached");
  EXPECT_GT(full.metrics.distance_m, 3.0) << "to and fro";
  EXPECT_EQ(run("s", lithium("0.544"), 15.0).verdict, "reached");
  const result::RunResult low = run("t", lithium("0.043"), 15.0);
  EXPECT_EQ(low.verdict, "stuck");
  EXPECT_THAT(low.why, testing::HasSubstr("left the line"));
  EXPECT_EQ(run("s", lithium("0.043"), 15.0).verdict, "reached");
}

TEST_F(Power, ThatTwoMotorsTakeAtOnceResetsTheChip) {
  EXPECT_EQ(run("h", alkaline("1"), 3.0).serial, "boot\r\n");
  const result::RunResult resets = run("h", alkaline("0.6"), 3.0);
  EXPECT_EQ(resets.serial, "boot\r\nboot\r\n");
  EXPECT_LT(resets.metrics.distance_m, 0.01);
  const result::RunResult rises = run("r", alkaline("0.6"), 3.0);
  EXPECT_EQ(rises.serial, "boot\r\n");
  EXPECT_GT(rises.metrics.distance_m, 0.3);
}

// The battery is almost empty. The robot moves a short distance, and then its board has no power.
TEST_F(Power, ThatIsGoneIsWhatARobotStandsFor) {
  for (const std::string target : {"host", "avr", "stm32"}) {
    SCOPED_TRACE(target);
    ROBOSIM_NEEDS_TARGET(target);
    const result::RunResult r =
        run("r", "kind = \"li-ion\"\ncells = 2\ncapacity_mAh = 1\ncharge = 0.02\n", 3.0, target);
    EXPECT_GT(r.metrics.distance_m, 0.01);
    EXPECT_THAT(r.why,
                testing::MatchesRegex(
                    ".* without a failure; the board has had no power since .* s: its battery is empty\\."));
  }
}

// Runs the sketch Pulses along a straight line of 5 m, with this driver chip and motors of this inductance.
result::RunResult pulses(const std::string& letter, const std::string& chip, const std::string& inductance,
                         const std::string& target = "host") {
  TemporaryFolder folder;
  const std::filesystem::path map = folder.path() / "floor.map", robot = folder.path() / "wound.toml";
  std::ofstream(map) << "+++\nsize = [\"6 m\", \"1 m\"]\n[start]\nalong = \"300 mm\"\n[[path]]\n"
                        "from = [\"200 mm\", \"500 mm\"]\nsegments = [{ length = \"5 m\" }]\n+++\n";
  std::ofstream(robot)
      << "base = \"uno5\"\nremove = \"all\"\n[driver]\nchip = \"" << chip << "\"\n[motors]\ninductance = \""
      << inductance
      << "\"\n[[part]]\nname = \"left\"\ntype = \"motor\"\npins = { en = 9, in1 = 7, in2 = 8 }\n"
         "[[part]]\nname = \"right\"\ntype = \"motor\"\npins = { en = 10, in1 = 12, in2 = 13 }\n";
  wire::RunRequest request = request_of({.sketch = "Pulses",
                                         .map = map.string(),
                                         .robot = robot.string(),
                                         .goal = "none",
                                         .script = "at 50ms send \"" + letter + "\"\n",
                                         .seed = 1,
                                         .for_s = 2.0,
                                         .target = target});
  request.profile = "ideal";
  return runner_of(target).run(request, {});
}

// While EN is low, the outputs of an L298N are open, and the winding's current quickly falls to zero.
TEST(Windings, OnAnL298nLetShortPulsesDoNothing) {
  const double without = pulses("f", "l298n", "0 mH").metrics.distance_m;
  EXPECT_NEAR(without, pulses("s", "l298n", "0 mH").metrics.distance_m, 1e-6);
  EXPECT_GT(without, 1.0);
  EXPECT_GT(pulses("s", "l298n", "1 mH").metrics.distance_m, 0.8 * without);
  EXPECT_EQ(pulses("f", "l298n", "1 mH").metrics.distance_m, 0.0);
  ROBOSIM_NEEDS_TARGET("avr");
  EXPECT_GT(pulses("s", "l298n", "1 mH", "avr").metrics.distance_m, 0.8 * without);
  EXPECT_EQ(pulses("f", "l298n", "1 mH", "avr").metrics.distance_m, 0.0);
}

TEST(Windings, OnATb6612TakeLessTheShorterThePulsesAre) {
  const result::RunResult none = pulses("s", "tb6612", "0 mH"), slow = pulses("s", "tb6612", "1 mH"),
                          fast = pulses("f", "tb6612", "1 mH");
  EXPECT_NEAR(slow.metrics.distance_m, none.metrics.distance_m, 0.001);
  EXPECT_NEAR(fast.metrics.distance_m, none.metrics.distance_m, 0.001);
  EXPECT_LT(slow.metrics.energy_j, 0.7 * none.metrics.energy_j);
  EXPECT_LT(fast.metrics.energy_j, 0.2 * none.metrics.energy_j);
}

TEST(Windings, GiveBackWhatASlowerDutyTakesAndBurnWhatAShortDoes) {
  EXPECT_EQ(pulses("d", "tb6612", "0 mH").metrics.energy_back_j, 0.0);
  EXPECT_GT(pulses("d", "tb6612", "1 mH").metrics.energy_back_j, 0.02);
  EXPECT_EQ(pulses("b", "tb6612", "1 mH").metrics.energy_back_j, 0.0);
}

}  // namespace power_test
}  // namespace robosim::test
