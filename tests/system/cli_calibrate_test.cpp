// `robosim calibrate`, the whole circle: a robot whose figures nobody has told is simulated, the sketch that
// comes with Robosim logs it, and the figures are found again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "sim/base/config.h"
#include "sim/base/noise.h"
#include "sim/base/units.h"
#include "tests/system/command.h"

namespace robosim::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string kLogger = ROBOSIM_SAMPLES "/CalibrationLogger";

/// Figures drawn at random, in the units in which they are written.
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
      // The floor's own brightness varies by 5 %: that is not the sensor's.
      EXPECT_NEAR(value_of(w), white[i], 0.04 * (black[i] - white[i]));
      EXPECT_NEAR(value_of(w), white[i], 1.5 * spread_of(w));
    }
    EXPECT_THAT(read_file(folder / "found.svg"),
                AllOf(HasSubstr("footprint"), HasSubstr("drive, told 255 and 255")));

    if (seed > 1) continue;
    // What there is stays, unless it is asked for.
    const std::string before = read_file(robot);
    const auto calibrate = [&](std::vector<std::string> more) {
      more.insert(more.begin(), {"calibrate", robot, log, "--tape", "19 mm"});
      return robosim_command(more);
    };
    EXPECT_EQ(calibrate({}).status, 0);
    EXPECT_EQ(read_file(robot), before);
    const Ended exists = calibrate({"--out", robot});
    EXPECT_EQ(exists.status, 2);
    EXPECT_THAT(exists.err, HasSubstr("unknown.toml: exists already, so nothing was written"));
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

}  // namespace
}  // namespace robosim::test
