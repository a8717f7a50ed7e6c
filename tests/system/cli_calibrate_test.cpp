// Tests `robosim calibrate` end to end. The sketch samples/CalibrationLogger writes a log on a simulated
// robot. The command must recover this robot's parameters from the log.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "sim/base/config.h"
#include "sim/base/noise.h"
#include "sim/base/units.h"
#include "tests/system/command.h"

namespace robosim::test {
namespace cli_calibrate_test {

using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string kLogger = ROBOSIM_SAMPLES "/CalibrationLogger";

/// A generator of random parameters, in the units of the robot file.
struct Drawn {
  explicit Drawn(std::uint64_t seed) : stream(seed, 0, "calibrate", "test") {}
  double operator()(double low, double high) { return low + (high - low) * stream.uniform(count++); }
  NoiseStream stream;
  std::uint64_t count = 0;
};

double number(const ConfigValue& value) {
  if (value.kind != ConfigValue::Kind::string) return value.number;
  return std::stod(value.string);
}

double value_of(const ConfigValue& figure) { return number(*figure.find("value")); }
double spread_of(const ConfigValue& figure) { return number(*figure.find("spread")); }

TEST(Calibrate, FindsWithinATenthTheFiguresOfARobotThatItDoesNotKnow) {
  for (const std::uint64_t seed : {1u, 2u}) {
    Drawn drawn(seed);
    const double supply = drawn(6.6, 8.2), footprint = drawn(0.8, 5.0), noise = drawn(0.005, 0.016);
    const double no_load = drawn(450.0, 850.0), torque = drawn(0.5, 1.0), friction = drawn(60.0, 220.0);
    const double track = drawn(90.0, 105.0), inertia = drawn(3000.0, 9000.0);
    std::vector<double> white, black;
    std::string whites, blacks;
    for (int i = 0; i < 5; ++i) {
      white.push_back(drawn(0.4, 0.9));
      black.push_back(drawn(3.7, 4.7));
      whites += fmt::format("\"{} V\", ", white.back());
      blacks += fmt::format("\"{} V\", ", black.back());
    }
    const Folder folder;
    const std::string robot =
        folder.write("unknown.toml", fmt::format(R"(base = "{}/robot.toml"
[chassis]
mass = "280 g"
wheel = "32 mm"
track = "{} mm"
inertia = "{} g cm2"
[motors]
supply = "{} V"
no_load = "{} rpm"
stall_torque = "{} kg cm"
no_load_current = "{} mA"
stall_current = "1.5 A"
[[part]]
name = "S"
height = "3 mm"
footprint = "{} mm"
noise = {}
white_volts = [{}]
black_volts = [{}]
)",
                                                 kLogger, track, inertia, supply, no_load, torque, friction,
                                                 footprint, noise, whites, blacks));
    const Ended run = robosim_command({"run", kLogger, "--robot", robot, "--map", kLogger + "/strip.map",
                                       "--goal", "none", "--for", "150s", "--profile", "typical@2", "--seed",
                                       std::to_string(seed), "--serial"});
    ASSERT_THAT(run.out, HasSubstr("# end")) << run.err;
    const std::string log = folder.write("log.csv", run.out);

    const Ended found = robosim_command({"calibrate", kLogger + "/robot.toml", log, "--tape", "19 mm",
                                         "--supply", fmt::format("{:.2f} V", supply), "--out",
                                         folder / "found.toml", "--plot", folder / "found.svg"});
    ASSERT_EQ(found.status, 0) << found.err;
    const ConfigValue tree = parse_toml(read_file(folder / "found.toml"), "found.toml");
    const auto expect = [&](const char* table, const char* key, double truth) {
      const ConfigValue* figure = tree.find(table)->find(key);
      ASSERT_NE(figure, nullptr) << key;
      EXPECT_NEAR(value_of(*figure), truth, 0.1 * truth) << key << ", seed " << seed;
      EXPECT_LT(spread_of(*figure), 0.1 * truth) << key;
    };
    expect("motors", "supply", supply);
    expect("motors", "no_load", no_load);
    expect("motors", "stall_torque", torque);
    expect("motors", "no_load_current", friction);
    expect("chassis", "track", track);
    expect("chassis", "inertia", inertia);
    const ConfigValue& part = tree.find("part")->items.front();
    EXPECT_NEAR(value_of(*part.find("footprint")), footprint, 0.1 * footprint);
    EXPECT_NEAR(value_of(*part.find("noise")), noise, 0.1 * noise);
    for (std::size_t i = 0; i < 5; ++i) {
      const ConfigValue &w = part.find("white_volts")->items[i], &b = part.find("black_volts")->items[i];
      EXPECT_NEAR(value_of(b), black[i], 0.01 * black[i]);
      // The floor's brightness varies by 5 %, independently of the sensor.
      EXPECT_NEAR(value_of(w), white[i], 0.04 * (black[i] - white[i]));
      EXPECT_NEAR(value_of(w), white[i], 1.5 * spread_of(w));
    }
    EXPECT_THAT(read_file(folder / "found.svg"),
                AllOf(HasSubstr("footprint"), HasSubstr("drive with 255 and 255")));

    if (seed > 1) continue;
    // Existing values stay unless the user replaces them.
    const std::string before = read_file(robot);
    const auto calibrate = [&](std::vector<std::string> more) {
      more.insert(more.begin(), {"calibrate", robot, log, "--tape", "19 mm"});
      return robosim_command(more);
    };
    EXPECT_EQ(calibrate({}).status, 0);
    EXPECT_EQ(read_file(robot), before);
    const Ended exists = calibrate({"--out", robot});
    EXPECT_EQ(exists.status, 2);
    EXPECT_THAT(exists.err, HasSubstr("unknown.toml: exists already; nothing was written"));
    std::filesystem::create_symlink("unknown.toml", folder / "link.toml");
    const Ended in_place =
        robosim_command({"calibrate", folder / "link.toml", log, "--tape", "19 mm", "--in-place"});
    EXPECT_EQ(in_place.status, 0) << in_place.err;
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.toml"));
    const std::string after = read_file(robot);
    EXPECT_THAT(
        after, AllOf(HasSubstr("wheel = \"32 mm\"\ntrack = { value = "), HasSubstr("\nheight = \"3 mm\"\n")));
    EXPECT_EQ(robosim_command({"robot", "check", robot}).status, 0);
  }
}

// Returns a map like samples/CalibrationLogger/strip.map, with the tape's middle `x_mm` from the left.
std::string strip_at(int x_mm) {
  std::string text = fmt::format(
      "+++\nline = \"19 mm\"\nsize = [\"8 m\", \"6 m\"]\ngoal = \"none\"\n[[path]]\nfrom = [\"{} mm\", \"3 "
      "m\"]\nsegments = [{{ length = \"240 mm\" }}]\n",
      x_mm - 120);
  for (int r = 160; r <= 2800; r += 110)
    text += fmt::format(
        "[[path]]\nfrom = [\"{} mm\", \"{} mm\"]\nsegments = [{{ radius = \"{} mm\", angle = \"360 deg\" "
        "}}]\n",
        x_mm, 3000 - r, r);
  return text + "[start]\npath = 1\nalong = \"120 mm\"\n+++\n";
}

TEST(Calibrate, FromFourPlacesTellsTheSensorsWhiteFromTheFloors) {
  constexpr double kWhite[] = {0.40, 0.55, 0.45, 0.60, 0.50};
  const Folder folder;
  const std::string robot = folder.write(
      "unknown.toml",
      fmt::format("base = \"{}/robot.toml\"\n[[part]]\nname = \"S\"\nheight = \"3 "
                  "mm\"\nwhite_volts = [\"0.40 V\", \"0.55 V\", \"0.45 V\", \"0.60 V\", \"0.50 V\"]\n",
                  kLogger));
  std::vector<std::string> command{"calibrate", kLogger + "/robot.toml", "--tape", "19 mm",
                                   "--out",     folder / "one.toml"};
  std::vector<double> spreads;
  for (const int x : {3000, 3300, 3600, 3900}) {
    const std::string map = folder.write(fmt::format("at{}.map", x), strip_at(x));
    const Ended run = robosim_command({"run", kLogger, "--robot", robot, "--map", map, "--goal", "none",
                                       "--for", "150s", "--profile", "typical@2", "--seed", "3", "--serial"});
    ASSERT_THAT(run.out, HasSubstr("# end")) << run.err;
    command.push_back(folder.write(fmt::format("at{}.csv", x), run.out));
    if (x > 3000 && x < 3900) continue;
    const Ended found = robosim_command(command);
    ASSERT_EQ(found.status, 0) << found.err;
    const ConfigValue tree = parse_toml(read_file(command[5]), "found.toml");
    const ConfigValue& white = *tree.find("part")->items.front().find("white_volts");
    spreads.push_back(spread_of(white.items[0]));
    for (std::size_t i = 0; i < 5 && x == 3900; ++i)
      EXPECT_NEAR(value_of(white.items[i]), kWhite[i], 0.1 * kWhite[i]) << i;
    command[5] = folder / "four.toml";
  }
  EXPECT_LT(spreads.at(1), 0.85 * spreads.at(0)) << "four circles have more patches than one";
}

}  // namespace cli_calibrate_test
}  // namespace robosim::test
