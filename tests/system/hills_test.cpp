// Tests effects of hills and wet floors on a sketch. A pair of runs, one with the effect and one without,
// shows that a value changes as docs/explanation/models.md describes. If one variant of the sketch fails
// because of the effect, another variant succeeds.
#include <fstream>

#include "sim/base/file.h"
#include "tests/support/temporary_folder.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace hills_test {

class Hills : public testing::Test {
 protected:
  /// Runs a sketch on a straight line of 2.4 m. The line has a gap of 100 mm, where `hills` may put a crest.
  /// The robot starts 300 mm along the line.
  result::RunResult run(const std::string& sketch, const std::string& hills, const std::string& letter,
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

  /// Returns a robot file: uno5 with these keys of `[chassis]`.
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
      const result::RunResult flat = run("ClimbsSlowly", "", way, 40.0, seed, "typical", heavy);
      EXPECT_EQ(flat.verdict, "reached") << flat.why;
      EXPECT_GT(flat.metrics.distance_m, 1.15) << way;
    }
    const result::RunResult stalls = run("ClimbsSlowly", kRamp, "p", 40.0, seed, "typical", heavy);
    EXPECT_EQ(stalls.verdict, "stuck") << stalls.why;
    EXPECT_LT(stalls.metrics.distance_m, 0.8);
    const result::RunResult climbs = run("ClimbsSlowly", kRamp, "i", 40.0, seed, "typical", heavy);
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
  // The sensors are 70 mm ahead of the axle, and 40 mm beyond the crest. The sensors' extra height is 40 mm
  // times the sine of 20 degrees.
  const double higher = 0.040 * 0.34202, light = 0.003 / (0.003 + higher);
  EXPECT_EQ(reads(""), code(0.4));
  EXPECT_NEAR(reads("[[hill]]\nalong = \"130 mm\"\nsize = [\"400 mm\", \"400 mm\"]\nslope = \"20 deg\"\n"
                    "[[hill]]\nalong = \"1.2 m\"\nsize = [\"1740 mm\", \"400 mm\"]\nheights = [\"136.8 mm\", "
                    "\"136.8 mm\"]\n"),
              code(4.4 - 4.0 * light * light), 3);
}

// A gap of 4 mm is two thirds of a sensor's view, which is 6 mm wide.
TEST_F(Hills, AreDarkWhereBoardsMeet) {
  const std::string serial =
      run("LooksInLight", "[[joint]]\nalong = \"370 mm\"\nsize = [\"4 mm\", \"400 mm\"]\n", "p", 0.1).serial;
  const double dark = 0.4 + 4.0 * 4.0 / 6.0;
  EXPECT_NEAR(std::atoi(serial.c_str() + serial.rfind('\n', serial.rfind("\r\n") - 2) + 1),
              static_cast<int>(dark / 5.0 * 1024.0), 1);
}

// The bar is 20 mm wide, and 1.5 m ahead of the robot's sensors. `joints` adds four gaps before the bar.
TEST_F(Hills, WhereBoardsMeetStopASketchThatTakesThemForABar) {
  const std::string bar =
      "[[area]]\ncolour = \"black\"\nalong = \"1.88 m\"\nsize = [\"20 mm\", \"400 mm\"]\n";
  std::string joints = bar;
  for (const char* along : {"600 mm", "900 mm", "1.2 m", "1.5 m"})
    joints += std::string("[[joint]]\nalong = \"") + along + "\"\nsize = [\"4 mm\", \"400 mm\"]\n";
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto way = [&](const char* letter, const std::string& floor) {
      const result::RunResult result = run("StopsAtBar", floor, letter, 15.0, seed, "typical");
      EXPECT_THAT(result.serial, testing::HasSubstr("bar"));
      return result.metrics.distance_m;
    };
    EXPECT_NEAR(way("o", bar), 1.53, 0.04);
    EXPECT_NEAR(way("b", bar), 1.55, 0.04);
    EXPECT_NEAR(way("o", joints), 0.26, 0.04);
    EXPECT_NEAR(way("b", joints), 1.55, 0.04);
  }
}

TEST_F(Hills, ThrowOverARobotWhoseMassIsHighAndBehind) {
  const std::string high = robot("caster = \"60 mm\"\nheight = \"60 mm\"\n");
  const result::RunResult flat = run("ClimbsSlowly", "", "i", 20.0, 1, "ideal", high);
  EXPECT_EQ(flat.verdict, "reached") << flat.why;
  const result::RunResult tips = run("ClimbsSlowly", kRamp, "i", 20.0, 1, "ideal", high);
  EXPECT_EQ(tips.verdict, "toppled") << tips.why;
  EXPECT_THAT(tips.why, testing::HasSubstr("The robot tipped over near column "));
}

// The floor is flat. The robot tips over if its acceleration exceeds g d / h. Its centre of mass is d = 10 mm
// ahead of the axle, at the height h.
TEST_F(Hills, AreNotNeededToThrowOverARobotThatStartsAtOnce) {
  const std::string low = robot("caster = \"50 mm\"\n");
  EXPECT_EQ(run("TurnsBack", "", "h", 1.2, 1, "ideal", low).verdict, "reached");
  const double without = run("TurnsBack", "", "r", 1.2, 1, "ideal", low).metrics.distance_m;
  const std::string high = robot("caster = \"50 mm\"\nheight = \"25 mm\"\n");
  const result::RunResult at_once = run("TurnsBack", "", "h", 1.2, 1, "ideal", high);
  EXPECT_EQ(at_once.verdict, "toppled") << at_once.why;
  const result::RunResult rises = run("TurnsBack", "", "r", 1.2, 1, "ideal", high);
  EXPECT_EQ(rises.verdict, "reached") << rises.why;
  EXPECT_GT(rises.metrics.distance_m, without * 1.03);  // the driven wheels carry more load, and grip better
}

TEST_F(Hills, ThatEndHighAreFallenOff) {
  const result::RunResult falls =
      run("ClimbsSlowly",
          "[[hill]]\nalong = \"700 mm\"\nsize = [\"600 mm\", \"400 mm\"]\nslope = \"10 deg\"\n", "i", 20.0);
  EXPECT_EQ(falls.verdict, "toppled");
  EXPECT_THAT(falls.why, testing::HasSubstr("The robot fell off an edge near column "));
}

// Runs the sample Robotracer on its course, dry and wet, at 0.5 and 0.7 m/s, without and with a fan. In bends
// of 150 mm radius, the robot slides if it is faster than sqrt(grip * load / mass * g * 0.15 m / sqrt 2).
// This limit is 0.91 m/s when dry, 0.71 m/s when wet, and 1.27 m/s when wet with the fan.
class Wet : public testing::Test {
 protected:
  result::RunResult run(int speed, bool wet, const std::string& fan, std::uint64_t seed) {
    const std::filesystem::path sample = ROBOSIM_SAMPLES "/Robotracer", map = folder_.path() / "course.map",
                                robot = folder_.path() / "robot.toml",
                                sketch = folder_.path() / ("Races" + std::to_string(speed));
    std::string code = read_file(sample / "Robotracer.ino"), course = read_file(sample / "course.map");
    const std::string set = "SPEED = 90";
    code.replace(code.find(set), set.size(), "SPEED = " + std::to_string(speed));
    std::filesystem::create_directories(sketch);
    std::ofstream(sketch / (sketch.filename().string() + ".ino")) << code;
    if (wet)
      course.insert(course.find("+++", 3),
                    "[[surface]]\nat = [\"1.45 m\", \"1 m\"]\nsize = [\"2.9 m\", \"2 m\"]\nkind = \"wet\"\n");
    std::ofstream(map) << course;
    std::ofstream(robot) << read_file(sample / "robot.toml") << "[chassis]\n" << fan;
    return test::run({.sketch = sketch.string(),
                      .map = map.string(),
                      .robot = robot.string(),
                      .goal = "robotrace",
                      .seed = seed,
                      .for_s = 20.0});
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(Wet, BendsLoseWhoIsFastUnlessAFanPressesItDown) {
  const int slow = 120, fast = 180;
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    for (const int speed : {slow, fast}) {
      EXPECT_EQ(run(speed, false, "", seed).verdict, "reached") << speed;
      const result::RunResult fan = run(speed, true, "downforce = \"500 g\"\n", seed);
      EXPECT_EQ(fan.verdict, "reached") << speed;
      EXPECT_LT(fan.metrics.cross_track_max_mm, 20.0);
    }
    EXPECT_EQ(run(slow, true, "", seed).verdict, "reached");
    const result::RunResult slides = run(fast, true, "", seed);
    EXPECT_EQ(slides.verdict, "timeout") << slides.why;
    EXPECT_GT(slides.metrics.cross_track_max_mm, 40.0);
    EXPECT_LT(slides.metrics.distance_m, 4.0);
  }
}

}  // namespace hills_test
}  // namespace robosim::test
