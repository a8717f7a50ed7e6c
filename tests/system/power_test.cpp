// What a battery does to a sketch: pairs of runs with a full one and a weak one, and a sketch that gets
// through beside one that does not.
#include <fstream>

#include "tests/support/temporary_folder.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace {

class Power : public testing::Test {
 protected:
  /// TurnsBack on a line of 1.2 m, on uno5 with this [battery].
  wire::RunResult run(const std::string& letter, const std::string& battery, double seconds,
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
                                           .for_s = seconds});
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

// By the curve in sim/robot/battery.h 54.4 % are 7.4 V at rest, and 4.3 % are 6.6 V.
TEST_F(Power, OfAnEmptierBatteryMakesATurnByTimeTooShort) {
  EXPECT_EQ(run("t", lithium("0.544"), 15.0).verdict, "reached");
  EXPECT_EQ(run("s", lithium("0.544"), 15.0).verdict, "reached");
  const wire::RunResult low = run("t", lithium("0.043"), 15.0);
  EXPECT_EQ(low.verdict, "stuck");
  EXPECT_THAT(low.why, testing::HasSubstr("left the line"));
  EXPECT_EQ(run("s", lithium("0.043"), 15.0).verdict, "reached");
}

TEST_F(Power, ThatTwoMotorsTakeAtOnceResetsTheChip) {
  EXPECT_EQ(run("h", alkaline("1"), 3.0).serial, "boot\r\n");
  const wire::RunResult resets = run("h", alkaline("0.6"), 3.0);
  EXPECT_EQ(resets.serial, "boot\r\nboot\r\n");
  EXPECT_LT(resets.metrics.distance_m, 0.01);
  const wire::RunResult rises = run("r", alkaline("0.6"), 3.0);
  EXPECT_EQ(rises.serial, "boot\r\n");
  EXPECT_GT(rises.metrics.distance_m, 0.3);
}

}  // namespace
}  // namespace robosim::test
