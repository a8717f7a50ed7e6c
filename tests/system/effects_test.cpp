// Tests effects of light, paint, sensors, ADC, gyroscope, battery, line width and a door on a sketch. Most
// tests compare runs without and with an effect. They expect the value that docs/explanation/models.md gives,
// or they expect that only one of two ways to read sensors succeeds.
#include <fmt/format.h>

#include <fstream>

#include "sim/base/file.h"
#include "tests/support/temporary_folder.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace effects_test {

const std::string kDivider = "[[part]]\nname = \"battery\"\ntype = \"voltage\"\npin = \"A5\"\nshare = 0.5\n";
const std::string kWeak = "source_ohms = \"1000 kohm\"\n";

struct Effect {
  const char* name;
  std::string robot;  ///< additional lines of the robot file
  std::string floor;  ///< additional lines of the map `oval`, or a whole map
  const char* profile;
  char survives, fails;  ///< ways to read the sensors: see sketches/LooksInLight
};

void PrintTo(const Effect& effect, std::ostream* out) { *out << effect.name; }

class Effects : public testing::Test {
 protected:
  result::RunResult run(const std::string& robot, const std::string& floor, const std::string& profile,
                        char way, std::uint64_t seed, double seconds, const std::string& script = "") {
    const std::filesystem::path map = folder_.path() / "floor.map", file = folder_.path() / "eyes.toml";
    std::string text = read_file(map::find_map("oval"));
    text.insert(text.find("+++", 3), floor);
    std::ofstream(map) << (floor.starts_with("+++") ? floor : text);
    std::ofstream(file)
        << "base = \"uno5\"\nremove = [\"bumper\", \"LED2\"]\n[[part]]\nname = \"S\"\nemitter = 12\n"
        << robot << (robot.find("share = 0.5") == robot.npos ? kDivider : "");
    wire::RunRequest request = request_of({.sketch = "LooksInLight",
                                           .map = map.string(),
                                           .robot = file.string(),
                                           .goal = way == 'p' || way == 'k' ? "none" : "laps:1",
                                           .script = std::string("at 50ms send \"") + way + "\"\n" + script,
                                           .seed = seed,
                                           .for_s = seconds});
    request.profile = profile;
    return runner_of("host").run(request, {});
  }

  /// Returns the last printed readings of the middle sensor and the battery. The robot stands on the line.
  std::pair<int, int> prints(const std::string& robot, const std::string& floor, double seconds,
                             const std::string& script = "", const std::string& profile = "ideal") {
    const std::string serial = run(robot, floor, profile, 'p', 1, seconds, script).serial;
    const std::size_t end = serial.rfind("\r\n"), begin = serial.rfind('\n', end - 2) + 1;
    int sensor = -1, battery = -1;
    std::istringstream(serial.substr(begin, end - begin)) >> sensor >> battery;
    return {sensor, battery};
  }

  int laps(const Effect& effect, bool with, char way) {
    int count = 0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
      count +=
          run(with ? effect.robot : "", with ? effect.floor : "", effect.profile, way, seed, 24.0).verdict ==
          "reached";
    return count;
  }

  TemporaryFolder folder_;
};

// Returns a map with a loop of 3.7 m. Its first half circle and its second straight have the keys `paint`.
std::string loop(const std::string& paint, const std::string& more = "") {
  return "+++\nsize = [\"1.8 m\", \"1.2 m\"]\n[[path]]\nfrom = [\"500 mm\", \"300 mm\"]\nsegments = [\n{ "
         "length = "
         "\"900 mm\" },\n{ radius = \"300 mm\", angle = \"180 deg\"" +
         paint + " },\n{ length = \"900 mm\"" + paint +
         " },\n{ radius = \"300 mm\", angle = \"180 deg\" }]\n" + more + "+++\n";
}

// Returns five white spots, like dust, over the line on one straight side of the oval.
std::string dirt() {
  std::string all;
  for (int i = 0; i < 5; ++i)
    all += fmt::format(
        "[[area]]\ncolour = \"white\"\nat = [\"{} mm\", \"250 mm\"]\nradius = \"8 mm\"\nover_lines = true\n",
        1300 + 100 * i);
  return all;
}

constexpr double kBlack = 4.4, kWhite = 0.4;  // V, readings of uno5

int code(double volts) { return static_cast<int>(volts / 5.0 * 1024.0); }

TEST_F(Effects, OfDaylightAreAsTheModelSays) {
  EXPECT_EQ(prints("", "", 0.1).first, code(kBlack));
  const double light = 0.25;
  EXPECT_EQ(prints("", "[[light]]\nlevel = 0.25\n", 0.1).first, code(kBlack - (kBlack - kWhite) * light));
  const double exposure = (64.0 / 89.0) / (9.0 / 34.0);
  EXPECT_EQ(prints("height = \"8 mm\"\n", "[[light]]\nlevel = 0.25\n", 0.1).first,
            code(kBlack - (kBlack - kWhite) * light * exposure));
}

TEST_F(Effects, OfAWeakBatteryOnTheReferenceAreAsTheModelSays) {
  const std::string weak = "at 60ms fault power sag 5.8V\n";
  EXPECT_EQ(prints("", "", 0.1, weak).second, code(2.9));
  EXPECT_EQ(prints("[electronics]\nfed_by_battery = true\n", "", 0.1, weak).second, code(2.9 / 4.0 * 5.0));
  EXPECT_EQ(prints("[electronics]\nfed_by_battery = true\n", "", 0.1, weak).first, code(kBlack));
}

// Tests the reading over a black, a grey, a glossy and a worn line, without noise (profile `ideal`).
TEST_F(Effects, OfPaintAreAsTheModelSays) {
  const auto seen = [&](const std::string& keys) {
    return prints("",
                  "+++\nsize = [\"1 m\", \"1 m\"]\n[[path]]\nfrom = [\"300 mm\", \"500 mm\"]\nsegments = [{ "
                  "length = "
                  "\"400 mm\"" +
                      keys + " }]\n[start]\nalong = \"100 mm\"\n+++\n",
                  0.1)
        .first;
  };
  EXPECT_EQ(seen(""), code(kBlack));
  EXPECT_EQ(seen(", colour = \"grey 45 %\""), code(kWhite + (kBlack - kWhite) * 0.45));
  EXPECT_EQ(seen(", gloss = \"5 %\""), code(kBlack - (kBlack - kWhite) * 0.05));
  EXPECT_EQ(seen(", worn = \"100 %\""), code(kWhite));
}

// The line is straight and 0.2 m long. A biased gyroscope reports 15 deg/s at rest. With the bias, only a
// sketch that subtracts it points straight ahead after a turn.
TEST_F(Effects, OfAGyroscopeWithABias) {
  const auto reaches = [&](const std::string& bias, char way) {
    const std::filesystem::path map = folder_.path() / "strip.map", file = folder_.path() / "turns.toml";
    std::ofstream(map) << "______\n_S.G__\n______\n";
    std::ofstream(file)
        << "base = \"uno3\"\nremove = [\"LED2\"]\n[[part]]\nname = \"gyro\"\ntype = \"mpu-6050\"\nbias = \""
        << bias << "\"\n";
    wire::RunRequest request = request_of({.sketch = "TurnsByGyro",
                                           .map = map.string(),
                                           .robot = file.string(),
                                           .goal = "station:goal",
                                           .script = std::string("at 50ms send \"") + way + "\"\n",
                                           .seed = 1,
                                           .for_s = 15.0});
    request.profile = "ideal";
    return runner_of("host").run(request, {}).verdict == "reached";
  };
  EXPECT_TRUE(reaches("0 deg/s", 'n'));
  EXPECT_TRUE(reaches("0 deg/s", 'o'));
  EXPECT_TRUE(reaches("15 deg/s", 'o'));
  EXPECT_FALSE(reaches("15 deg/s", 'n'));
}

// If the ADC's reference drops with the battery, a measurement of the battery does not show the drop.
TEST_F(Effects, OfAReferenceThatSinksHideAWeakBattery) {
  const auto notices = [&](const std::string& robot) {
    return run(robot, "", "ideal", 'v', 1, 4.0, "at 2s fault power sag 5.8V\n").serial.find("low") !=
           std::string::npos;
  };
  EXPECT_TRUE(notices(""));
  EXPECT_FALSE(notices("[electronics]\nfed_by_battery = true\n"));
}

// With a weak source, the reading of the battery's 3.7 V is too high. The error is 24 to 43 % of the
// difference between 3.7 V and the 4.4 V of the previous channel.
TEST_F(Effects, OfAWeakSourceShiftReadingsTowardsThePreviousChannel) {
  EXPECT_EQ(prints("", "", 0.1).second, code(3.7));
  const int read = prints(kDivider + kWeak, "", 0.1).second;
  EXPECT_GE(read, code(3.7 + 0.24 * (kBlack - 3.7)));
  EXPECT_LE(read, code(3.7 + 0.43 * (kBlack - 3.7)) + 1);
}

// The path is 90 mm wide, although the map's `line` is 20 mm. A robot on the path's edge must not count as
// lost.
TEST_F(Effects, OfAWideLineDoNotIncludeLosingItAtItsEdge) {
  const std::string loop =
      "+++\nline = \"20 mm\"\nsize = [\"1.8 m\", \"1.2 m\"]\n[[path]]\nwidth = \"90 mm\"\nfrom = [\"500 "
      "mm\", "
      "\"300 mm\"]\nsegments = [{ length = \"900 mm\" }, { radius = \"300 mm\", angle = \"180 deg\" }, { "
      "length "
      "= \"900 mm\" }, { radius = \"300 mm\", angle = \"180 deg\" }]\n+++\n";
  const result::RunResult result = run("", loop, "typical", 'k', 1, 12.0);
  EXPECT_EQ(result.verdict, "reached") << result.why;
  EXPECT_GT(result.metrics.distance_m, 2.0);
}

// A script switches on a light of level 0.6 over the whole floor. A sketch that was calibrated without the
// light still detects black. A sketch with a threshold at half scale no longer does.
TEST_F(Effects, OfALightThatIsSwitchedOnInTheRun) {
  const std::string lit = "[[light]]\nlevel = 0.6\n", off = "at 0s light all off\n";
  EXPECT_EQ(prints("", lit, 0.1, off).first, code(kBlack));
  EXPECT_EQ(prints("", lit, 0.1, off + "at 80ms light all on\n").first,
            code(kBlack - (kBlack - kWhite) * 0.6));
  EXPECT_EQ(prints("", lit, 0.1, "at 80ms light all off\n").first, code(kBlack));
  const auto drives = [&](char way, const std::string& script) {
    return run("", lit, "typical", way, 1, 24.0, script).verdict == "reached";
  };
  EXPECT_TRUE(drives('c', off));
  EXPECT_TRUE(drives('t', off));
  EXPECT_TRUE(drives('c', off + "at 5s light all on\n"));
  EXPECT_FALSE(drives('t', off + "at 5s light all on\n"));
}

// The door is shut across the line, 1 m ahead.
TEST_F(Effects, OfADoorThatIsShut) {
  const auto run = [](const std::string& sketch, const std::string& script) {
    return test::run({.sketch = sketch,
                      .robot = ROBOSIM_SAMPLES "/StopsForBox/robot.toml",
                      .goal = "none",
                      .script = script,
                      .for_s = 6.0});
  };
  const std::string stops = ROBOSIM_SAMPLES "/StopsForBox", shut = "at 0s door 20,12 20,16 shut";
  EXPECT_EQ(run("LeftPath", "").metrics.collisions, 0);
  EXPECT_EQ(run("LeftPath", shut).metrics.collisions, 1);
  const result::RunResult open = run(stops, ""), waits = run(stops, shut),
                          goes_on = run(stops, shut + " for 4s");
  EXPECT_EQ(open.metrics.collisions + waits.metrics.collisions + goes_on.metrics.collisions, 0);
  EXPECT_GT(goes_on.metrics.distance_m, waits.metrics.distance_m + 0.1);
  EXPECT_GT(open.metrics.distance_m, goes_on.metrics.distance_m + 0.1);
}

class Survival : public Effects, public testing::WithParamInterface<Effect> {};

TEST_P(Survival, DependsOnHowTheSketchReadsSensors) {
  const Effect& effect = GetParam();
  EXPECT_EQ(laps(effect, false, effect.survives), 3) << "without the effect, both ways succeed";
  EXPECT_EQ(laps(effect, false, effect.fails), 3) << "without the effect, both ways succeed";
  EXPECT_EQ(laps(effect, true, effect.survives), 3);
  EXPECT_EQ(laps(effect, true, effect.fails), 0);
}

INSTANTIATE_TEST_SUITE_P(
    Of, Survival,
    testing::Values(
        Effect{"ALamp", "", "[[light]]\nlevel = 0.8\nat = [\"1.2 m\", \"200 mm\"]\nheight = \"300 mm\"\n",
               "typical", 'c', 't'},
        Effect{"Sun", "", "[[light]]\nlevel = 0.65\nat = [\"1.2 m\", \"300 mm\"]\nradius = \"250 mm\"\n",
               "typical", 'c', 't'},
        Effect{"AHighSensorInDaylight", "height = \"8 mm\"\n", "[[light]]\nlevel = 0.25\n", "typical@2", 'c',
               't'},
        Effect{"Flicker", "", "[[light]]\nlevel = 0.6\nflicker = 1\n", "typical", 'l', 'e'},
        Effect{"ASlowPhototransistor", "rise = \"500 us\"\n", "", "typical", 'w', 'd'},
        Effect{"AWornLine", "", "worn = \"30 %\"\n", "typical", 'l', 'e'},
        Effect{"AFadedStretch", "", loop(", colour = \"grey 45 %\""), "typical", 'c', 't'},
        Effect{"ANarrowStretch", "", loop(", width = \"4 mm\""), "typical", 'l', 'e'},
        Effect{"AGlossyLine", "", "gloss = \"55 %\"\n", "typical", 'c', 't'},
        Effect{"DullElements", "black_volts = [\"2.3 V\", \"2.4 V\", \"2.2 V\", \"2.3 V\", \"2.4 V\"]\n", "",
               "typical", 'c', 't'},
        Effect{"Dirt", "", dirt(), "typical", 'l', 'e'},
        Effect{"ADarkFloor", "",
               "[[area]]\ncolour = \"grey 60 %\"\nat = [\"1.25 m\", \"850 mm\"]\nsize = [\"2.5 "
               "m\", \"1.7 m\"]\n",
               "typical", 'c', 't'},
        Effect{"AGreenStretch", "", loop(", colour = \"green\""), "typical", 'c', 't'},
        Effect{"ASilverStrip", "",
               loop("",
                    "[[area]]\ncolour = \"silver\"\nalong = \"700 mm\"\nsize = [\"12 mm\", \"250 "
                    "mm\"]\nover_lines = true\n"),
               "typical", 'l', 'e'},
        Effect{"AMovingSun", "",
               "[[light]]\nlevel = 0.65\nat = [\"1.9 m\", \"850 mm\"]\nradius = \"250 mm\"\nmoves = [\"40 "
               "mm/s\", \"0 mm/s\"]\n",
               "typical", 'c', 't'},
        Effect{"ANoisyAdc", "[electronics]\nadc_noise = 12\n", "", "typical", 'v', 'b'},
        Effect{"AWeakSource", kDivider + kWeak, "", "typical", 'v', 'b'}),
    [](const auto& effect) { return std::string(effect.param.name); });

}  // namespace effects_test
}  // namespace robosim::test
