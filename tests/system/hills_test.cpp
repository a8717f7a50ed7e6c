// What hills do to a sketch: pairs of runs without and with them, in which a figure changes as docs/models.md
// says, and a sketch that gets through beside one that does not.
#include <fstream>

#include "sim/base/file.h"
#include "tests/support/temporary_folder.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace {

class Hills : public testing::Test {
 protected:
  /// On a straight line of 2.4 m, with a gap of 100 mm where `hills` may put a crest; the robot starts 300 mm
  /// along it.
  wire::RunResult run(const std::string& sketch, const std::string& hills, const std::string& letter,
                      double seconds, std::uint64_t seed = 1, const std::string& profile = "ideal",
                      const std::string& robot = "uno5") {
    const std::filesystem::path map = folder_.path() / "strip.map";
    std::ofstream(map)
        << "+++\nsize = [\"3 m\", \"600 mm\"]\ngoal = \"none\"\n[start]\nalong = \"300 mm\"\n[[path]]\n"
           "from = [\"200 mm\", \"300 mm\"]\nsegments = [{ length = \"330 mm\" }, "
           "{ length = \"100 mm\", gap = true }, { length = \"1970 mm\" }]\n"
        << hills << "+++\n";
    wire::RunRequest request = request_of({.sketch = sketch,
                                           .map = map.string(),
                                           .robot = robot,
                                           .goal = "none",
                                           .script = "at 50ms send \"" + letter + "\"\n",
                                           .seed = seed,
                                           .for_s = seconds});
    request.profile = profile;
    return runner_of("host").run(request, {});
  }

  /// uno5 with another chassis.
  std::string robot(const std::string& chassis) {
    const std::filesystem::path file = folder_.path() / "other.toml";
    std::ofstream(file) << "base = \"uno5\"\n[chassis]\n" << chassis;
    return file.string();
  }

 private:
  TemporaryFolder folder_;
};

constexpr const char* kRamp =
    "[[hill]]\nalong = \"1.2 m\"\nsize = [\"800 mm\", \"400 mm\"]\nslope = \"20 deg\"\n"
    "[[hill]]\nalong = \"2.2 m\"\nsize = [\"1.2 m\", \"400 mm\"]\nheights = [\"273.6 mm\", \"273.6 mm\"]\n";

TEST_F(Hills, StopASketchWithoutAnIntegralTerm) {
  const std::string heavy = robot("mass = \"500 g\"\n");
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    for (const char* way : {"p", "i"}) {
      const wire::RunResult flat = run("ClimbsSlowly", "", way, 40.0, seed, "typical", heavy);
      EXPECT_EQ(flat.verdict, "reached") << flat.why;
      EXPECT_GT(flat.metrics.distance_m, 1.15) << way;
    }
    const wire::RunResult stalls = run("ClimbsSlowly", kRamp, "p", 40.0, seed, "typical", heavy);
    EXPECT_EQ(stalls.verdict, "stuck") << stalls.why;
    EXPECT_LT(stalls.metrics.distance_m, 0.8);
    const wire::RunResult climbs = run("ClimbsSlowly", kRamp, "i", 40.0, seed, "typical", heavy);
    EXPECT_EQ(climbs.verdict, "reached") << climbs.why;
    EXPECT_GT(climbs.metrics.distance_m, 1.15);
  }
}

TEST_F(Hills, LiftSensorsOverACrest) {
  const auto reads = [this](const std::string& hills) {
    const std::string serial = run("LooksInLight", hills, "p", 0.1).serial;
    return std::atoi(serial.c_str() + serial.rfind('\n', serial.rfind("\r\n") - 2) + 1);
  };
  const auto code = [](double volts) { return static_cast<int>(volts / 5.0 * 1024.0); };
  // Its sensors are 70 mm ahead, 30 mm of them up to the crest: 40 mm by the sine of 20 degrees too high.
  const double higher = 0.040 * 0.34202, light = 0.003 / (0.003 + higher);
  EXPECT_EQ(reads(""), code(0.4));
  EXPECT_NEAR(reads("[[hill]]\nalong = \"130 mm\"\nsize = [\"400 mm\", \"400 mm\"]\nslope = \"20 deg\"\n"
                    "[[hill]]\nalong = \"1.2 m\"\nsize = [\"1740 mm\", \"400 mm\"]\nheights = [\"136.8 mm\", "
                    "\"136.8 mm\"]\n"),
              code(4.4 - 4.0 * light * light), 3);
}

TEST_F(Hills, ThrowOverARobotWhoseMassIsHighAndBehind) {
  const std::string high = robot("caster = \"60 mm\"\nheight = \"60 mm\"\n");
  const wire::RunResult flat = run("ClimbsSlowly", "", "i", 20.0, 1, "ideal", high);
  EXPECT_EQ(flat.verdict, "reached") << flat.why;
  const wire::RunResult tips = run("ClimbsSlowly", kRamp, "i", 20.0, 1, "ideal", high);
  EXPECT_EQ(tips.verdict, "toppled") << tips.why;
  EXPECT_THAT(tips.why, testing::HasSubstr("The robot tipped over near column "));
}

// On plane floor. It would tip where it speeds up by more than g d / h, its mass d = 10 mm ahead of the axle.
TEST_F(Hills, AreNotNeededToThrowOverARobotThatStartsAtOnce) {
  const std::string low = robot("caster = \"50 mm\"\n");
  EXPECT_EQ(run("TurnsBack", "", "h", 1.2, 1, "ideal", low).verdict, "reached");
  const double without = run("TurnsBack", "", "r", 1.2, 1, "ideal", low).metrics.distance_m;
  const std::string high = robot("caster = \"50 mm\"\nheight = \"25 mm\"\n");
  const wire::RunResult at_once = run("TurnsBack", "", "h", 1.2, 1, "ideal", high);
  EXPECT_EQ(at_once.verdict, "toppled") << at_once.why;
  const wire::RunResult rises = run("TurnsBack", "", "r", 1.2, 1, "ideal", high);
  EXPECT_EQ(rises.verdict, "reached") << rises.why;
  EXPECT_GT(rises.metrics.distance_m, without * 1.03);  // what the caster loses the driven wheels gain: grip
}

TEST_F(Hills, ThatEndHighAreFallenOff) {
  const wire::RunResult falls =
      run("ClimbsSlowly",
          "[[hill]]\nalong = \"700 mm\"\nsize = [\"600 mm\", \"400 mm\"]\nslope = \"10 deg\"\n", "i", 20.0);
  EXPECT_EQ(falls.verdict, "toppled");
  EXPECT_THAT(falls.why, testing::HasSubstr("The robot fell off an edge near column "));
}

}  // namespace
}  // namespace robosim::test
