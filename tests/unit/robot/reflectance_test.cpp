// Tests reflectance sensors with an analog output.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/base/error.h"
#include "sim/robot/parts/reflectance.h"
#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace reflectance_test {

TEST(Blackness, IsOneMinusTheLightThatReturns) {
  EXPECT_DOUBLE_EQ(blackness({.light = 1.0, .white = 1.0}), 0.0);
  EXPECT_DOUBLE_EQ(blackness({.light = 1.0, .white = 0.0}), 1.0);
  EXPECT_DOUBLE_EQ(blackness({.light = 0.5, .white = 0.8, .brightness = 1.1}), 0.56);
  EXPECT_DOUBLE_EQ(blackness({.light = 0.5, .white = 0.8, .shift = -0.1, .room_light = 0.3}), 0.2);
}

TEST(Blackness, HasLessNoiseOverBlack) {
  EXPECT_DOUBLE_EQ(blackness({.light = 1.0, .white = 1.0, .noise = 0.1, .dark_noise = 0.4, .gauss = 2.0}),
                   0.2);
  EXPECT_DOUBLE_EQ(blackness({.light = 1.0, .white = 0.0, .noise = 0.1, .dark_noise = 0.4, .gauss = 2.0}),
                   1.08);
  EXPECT_DOUBLE_EQ(blackness({.light = 1.0, .white = 0.5, .noise = 0.1, .dark_noise = 0.4, .gauss = -1.0}),
                   0.43);
}

TEST(AnalogReflectance, GoesFromWhiteToBlackOverOneFootprint) {
  BenchRobot bench(reflectance_sensor("white_volts = \"0.5 V\"\nblack_volts = \"4.5 V\"\n"));
  EXPECT_DOUBLE_EQ(bench.volts(kA0), 4.5);
  place_beside_line(bench, 0.010);
  EXPECT_NEAR(bench.volts(kA0), 2.5, 1e-9);
  place_beside_line(bench, 0.0115);
  EXPECT_NEAR(bench.volts(kA0), 1.5, 1e-9);
  place_beside_line(bench, 0.030);
  EXPECT_DOUBLE_EQ(bench.volts(kA0), 0.5);
}

TEST(AnalogReflectance, EachElementOfAnArrayMayHaveVoltagesOfItsOwn) {
  BenchRobot bench(
      "[[part]]\nname = \"eyes\"\ntype = \"reflectance-array\"\npins = [\"A0\", \"A1\"]\n"
      "at = [\"70 mm\", \"0 mm\"]\npitch = \"2 mm\"\nwhite_volts = [\"0.2 V\", \"0.7 V\"]\n"
      "black_volts = \"4.5 V\"\n");
  place_beside_line(bench, 0.03);
  EXPECT_DOUBLE_EQ(bench.volts(kA0), 0.2);
  EXPECT_DOUBLE_EQ(bench.volts(static_cast<Pin>(kA0 + 1)), 0.7);
}

TEST(AnalogReflectance, BlackLowSwapsTheDefaults) {
  BenchRobot bench(reflectance_sensor("black = \"low\"\n"));
  EXPECT_LT(bench.volts(kA0), 1.0);
  place_beside_line(bench, 0.030);
  EXPECT_GT(bench.volts(kA0), 4.0);
}

TEST(AnalogReflectance, ReadsInsideTheTickSeeTheBodyMove) {
  BenchRobot bench(reflectance_sensor("") + R"([[part]]
name = "left"
type = "motor"
pins = { in1 = 5, in2 = 6 }
[[part]]
name = "right"
type = "motor"
pins = { in1 = 9, in2 = 10 }
)");
  bench.body().place({bench.line() + Vec2{0.0, -0.025}, {0.0, 1.0}});
  bench.board.output(5, true, 0);
  bench.board.output(9, true, 0);
  while (bench.volts(kA0) < 2.0) bench.tick();
  const double first = bench.volts(kA0);
  const double last = bench.board.read_volts(kA0, bench.now + kTick - 1);
  EXPECT_GT(last, first + 0.05);
  bench.tick();
  EXPECT_NEAR(bench.volts(kA0), last, 1e-3) << "the next tick begins where the extrapolation ended";
}

TEST(AnalogReflectance, AHigherSensorSeesLessContrastAndABiggerSpot) {
  BenchRobot near(reflectance_sensor("height = \"3 mm\"\n"));
  BenchRobot far(reflectance_sensor("height = \"6 mm\"\n"));
  EXPECT_DOUBLE_EQ(near.volts(kA0), far.volts(kA0));
  place_beside_line(near, 0.03);
  place_beside_line(far, 0.03);
  EXPECT_NEAR(far.volts(kA0), 4.5 - (4.5 - near.volts(kA0)) / 4.0, 1e-9);
}

// Returns the sensor's voltage over white, far from the line. The file specifies 0.5 V for white and 4.5 V
// for black.
double white_volts(const std::string& keys, Profile profile, std::uint64_t seed = 1) {
  BenchRobot bench(reflectance_sensor("white_volts = \"0.5 V\"\nblack_volts = \"4.5 V\"\nnoise = 0\n" + keys),
                   profile, seed);
  place_beside_line(bench, 0.03);
  return bench.volts(kA0);
}

TEST(AnalogReflectance, LosesLightByHeightAsATcrt5000DoesFromTypical2On) {
  const auto share = [](const char* height, Profile profile) {
    return (4.5 - white_volts(std::string("height = \"") + height + "\"\n", profile)) / 4.0;
  };
  for (const Profile before : {Profile::ideal, Profile::typical_1}) {
    EXPECT_NEAR(share("1 mm", before), 1.0, 1e-9);
    EXPECT_NEAR(share("9 mm", before), 1.0 / 9.0, 1e-9);
  }
  EXPECT_NEAR(share("1 mm", Profile::typical_2), 0.83, 1e-9);
  EXPECT_NEAR(share("2.5 mm", Profile::typical_2), 1.0, 1e-9);
  EXPECT_NEAR(share("9 mm", Profile::typical_2), 0.42, 1e-9);
  EXPECT_NEAR(share("30 mm", Profile::typical_2), 0.085, 1e-9);
}

TEST(AnalogReflectance, SeesASmallerSpotFromTypical2OnOneForAllElements) {
  const std::string keys =
      "[[part]]\nname = \"eyes\"\ntype = \"reflectance-array\"\npins = [\"A0\", \"A1\"]\nnoise = 0\n"
      "at = [\"70 mm\", \"0 mm\"]\npitch = \"2 mm\"\nheight = \"8 mm\"\n";
  const auto edge = [&](BenchRobot& bench, Pin pin) {  // width in m of the change from white to black
    int between = 0;
    double low = 9.0, high = 0.0;
    std::vector<double> seen;
    for (int i = 0; i < 400; ++i) {
      place_beside_line(bench, i * 1e-4);
      seen.push_back(bench.volts(pin));
      low = std::min(low, seen.back());
      high = std::max(high, seen.back());
    }
    for (const double v : seen) between += v > low + 0.01 && v < high - 0.01;
    return between * 1e-4;
  };
  double least = 1.0, most = 0.0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    BenchRobot bench(keys, Profile::typical_2, seed);
    const double spot = edge(bench, kA0);
    EXPECT_NEAR(edge(bench, kA1), spot, 4e-4) << seed;
    least = std::min(least, spot);
    most = std::max(most, spot);
  }
  EXPECT_NEAR(least, 0.24 * 0.008, 0.0006);
  EXPECT_NEAR(most, 0.96 * 0.008, 0.0006);
}

TEST(AnalogReflectance, IsLessNoisyOverBlackFromTypical2On) {
  const auto noise = [](Profile profile, double beside_line) {
    BenchRobot bench(reflectance_sensor("noise = 0.01\n"), profile, 3);
    place_beside_line(bench, beside_line);
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < 4000; ++i) {
      const double v = bench.volts(kA0);
      sum += v;
      squares += v * v;
    }
    return std::sqrt(squares / 4000 - sum * sum / 16e6);
  };
  EXPECT_NEAR(noise(Profile::typical_1, 0.0) / noise(Profile::typical_1, 0.03), 1.0, 0.05);
  EXPECT_NEAR(noise(Profile::typical_2, 0.0) / noise(Profile::typical_2, 0.03), 0.4, 0.05);
}

TEST(AnalogReflectance, SeesTheBrightnessOfTheFloor) {
  BenchRobot bench(reflectance_sensor("white_volts = \"0.5 V\"\nblack_volts = \"4.5 V\"\n"));
  bench.world.vary_floor(NoiseStream(1, 0, "floor", "brightness"), 0.05);
  place_beside_line(bench, 0.03);
  const double bright = bench.world.floor().brightness(bench.line() + Vec2{0.0, 0.03});
  EXPECT_NE(bright, 1.0);
  EXPECT_NEAR(bench.volts(kA0), 4.5 - 4.0 * bright, 1e-9);
  place_beside_line(bench, 0.0);
  EXPECT_DOUBLE_EQ(bench.volts(kA0), 4.5) << "the line's reflectance does not vary";
}

TEST(AnalogReflectance, TheEmitterPinTurnsTheLightOff) {
  BenchRobot bench(reflectance_sensor("emitter = 3\n"));
  place_beside_line(bench, 0.03);
  const double lit = bench.volts(kA0);
  EXPECT_LT(lit, 1.0) << "the emitter is on while its pin is not driven";
  bench.board.output(3, false, 0);
  EXPECT_GT(bench.volts(kA0), 4.0);
  bench.board.output(3, true, 0);
  EXPECT_DOUBLE_EQ(bench.volts(kA0), lit);
}

TEST(AnalogReflectance, TypicalSensorsDifferAndAreNoisy) {
  const std::string keys = "noise = 0.01\nwhite_volts = { value = \"0.4 V\", spread = \"25 %\" }\n";
  BenchRobot one(reflectance_sensor(keys), Profile::typical, 1);
  BenchRobot other(reflectance_sensor(keys), Profile::typical, 2);
  place_beside_line(one, 0.03);
  place_beside_line(other, 0.03);
  double sum[2] = {}, squares = 0.0;
  constexpr int kCount = 4000;
  for (int i = 0; i < kCount; ++i) {
    const double v = one.volts(kA0);
    sum[0] += v;
    squares += v * v;
    sum[1] += other.volts(kA0);
  }
  const double mean = sum[0] / kCount;
  EXPECT_NEAR(std::sqrt(squares / kCount - mean * mean), 0.01 * (4.5 - mean), 0.002);
  EXPECT_GT(std::abs(sum[1] / kCount - mean), 0.002);
  EXPECT_THAT(mean, ::testing::AllOf(::testing::Gt(0.29), ::testing::Lt(0.51)));
}

TEST(AnalogReflectance, EqualSeedsGiveEqualReadingsWhateverElseIsOnTheRobot) {
  BenchRobot alone(reflectance_sensor("noise = 0.01\n"), Profile::typical, 7);
  BenchRobot more(
      "[[part]]\nname = \"other\"\ntype = \"reflectance\"\npin = \"A1\"\nat = [\"5 mm\", \"0 mm\"]\n" +
          reflectance_sensor("noise = 0.01\n"),
      Profile::typical, 7);
  for (int i = 0; i < 100; ++i) {
    more.volts(kA0 + 1);
    EXPECT_EQ(alone.volts(kA0), more.volts(kA0));
  }
}

TEST(AnalogReflectance, ArraysRunFromLeftToRight) {
  BenchRobot bench(R"([[part]]
name = "S"
type = "reflectance-array"
pins = ["A0", "A1", "A2"]
at = ["0 mm", "0 mm"]
pitch = "15 mm"
footprint = "6 mm"
)");
  place_beside_line(bench, -0.015);
  EXPECT_GT(bench.volts(kA0), 4.0) << "the robot stands to the right of the line";
  EXPECT_LT(bench.volts(kA0 + 1), 1.0);
  const auto readings = bench.robot.readings();
  ASSERT_EQ(readings.size(), 3u);
  EXPECT_EQ(readings[0].part, "S1");
  EXPECT_EQ(readings[0].value, 1.0);
  EXPECT_EQ(readings[2].value, 0.0);
}

TEST(ReflectanceFaults, StuckDeadOffsetAndOk) {
  BenchRobot bench(reflectance_sensor("white_volts = \"0.5 V\"\nblack_volts = \"4.5 V\"\n"));
  place_beside_line(bench, 0.03);
  const auto with = [&](const char* kind, std::vector<std::string> arguments) {
    bench.robot.fault("eye", kind, arguments);
    return bench.volts(kA0);
  };
  EXPECT_EQ(static_cast<int>(with("stuck", {"1023"}) / 5.0 * 1024), 1023);
  EXPECT_EQ(static_cast<int>(with("stuck", {"7"}) / 5.0 * 1024), 7);
  EXPECT_EQ(with("dead", {}), 4.5);
  EXPECT_NEAR(with("offset", {"25%"}), 1.5, 1e-9);
  EXPECT_EQ(with("ok", {}), 0.5);
}

TEST(ReflectanceFaults, NoisyComesOnTopEvenInTheIdealProfile) {
  BenchRobot bench(reflectance_sensor("noise = 0.0\n"));
  place_beside_line(bench, 0.010);
  const double quiet = bench.volts(kA0);
  bench.robot.fault("eye", "noisy", {"0.1"});
  double most = 0.0;
  for (int i = 0; i < 100; ++i) most = std::max(most, std::abs(bench.volts(kA0) - quiet));
  EXPECT_GT(most, 0.2);
}

TEST(ReflectanceFaults, SwappedSensorsSeeEachOthersFloor) {
  BenchRobot bench(reflectance_sensor("") +
                   "[[part]]\nname = \"side\"\ntype = \"reflectance\"\npin = \"A1\"\n"
                   "at = [\"0 mm\", \"40 mm\"]\n");
  const double black = bench.volts(kA0), white = bench.volts(kA0 + 1);
  bench.robot.fault("eye", "swapped", {"side"});
  EXPECT_EQ(bench.volts(kA0), white);
  EXPECT_EQ(bench.volts(kA0 + 1), black);
}

TEST(ReflectanceFaults, ASwapEndsForBothWithTheNextFaultOfEither) {
  const auto other = [](const char* name, const char* pin, const char* y) {
    return std::string("[[part]]\nname = \"") + name + "\"\ntype = \"reflectance\"\npin = \"" + pin +
           "\"\nat = [\"0 mm\", \"" + y + "\"]\n";
  };
  BenchRobot bench(reflectance_sensor("") + other("side", "A1", "40 mm") + other("edge", "A2", "10 mm"));
  const double black = bench.volts(kA0), white = bench.volts(kA0 + 1), grey = bench.volts(kA0 + 2);
  const auto sees = [&](double a0, double a1, double a2) {
    EXPECT_EQ(bench.volts(kA0), a0);
    EXPECT_EQ(bench.volts(kA0 + 1), a1);
    EXPECT_EQ(bench.volts(kA0 + 2), a2);
  };
  bench.robot.fault("eye", "swapped", {"side"});
  bench.robot.fault("side", "ok", {});
  sees(black, white, grey);
  bench.robot.fault("eye", "swapped", {"side"});
  bench.robot.fault("edge", "swapped", {"side"});
  sees(black, grey, white);
  bench.robot.fault("edge", "ok", {});
  sees(black, white, grey);
}

TEST(ReflectanceFaults, UnknownWordsSayWhatThereIs) {
  BenchRobot bench(reflectance_sensor(""));
  const auto message = [&](const char* part, const char* kind, std::vector<std::string> arguments) {
    try {
      bench.robot.read_fault(part, kind, arguments);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_THAT(message("ear", "dead", {}), ::testing::HasSubstr("eye"));
  EXPECT_THAT(message("eye", "blind", {}), ::testing::HasSubstr("ok, stuck, dead, swapped, noisy or offset"));
  EXPECT_THAT(message("eye", "stuck", {}), ::testing::HasSubstr("one number"));
  EXPECT_THAT(message("eye", "stuck", {"much"}), ::testing::HasSubstr("from 0 to 1e+06"));
  EXPECT_THAT(message("eye", "swapped", {"eye"}), ::testing::HasSubstr("another"));
  EXPECT_THAT(message("eye", "dead", {"3"}), ::testing::HasSubstr("expected nothing after it"));
  EXPECT_EQ(message("eye", "stuck", {"512"}), "accepted");
  place_beside_line(bench, 0.03);
  EXPECT_LT(bench.volts(kA0), 1.0) << "read_fault() does not cause the fault";
}

TEST(Reflectance, WhatIsShownDoesNotDependOnWhetherTheLineWasSoughtBefore) {
  for (const std::string map : {"", "+++\npaint = \"white on black\"\n+++\n"}) {
    const Description description = parse_description(kBareRobot + reflectance_sensor(""), "bench.toml");
    BenchRobot seeks(description, Profile::typical, 3, map), never(description, Profile::typical, 3, map);
    const auto shown = [](BenchRobot& bench) { return bench.robot.readings().front().value; };
    for (const double aside : {0.0, 0.009, 0.011, 0.013, 0.03}) {
      for (BenchRobot* bench : {&seeks, &never}) place_beside_line(*bench, aside);
      EXPECT_EQ(shown(seeks), shown(never)) << "the robot has moved since the last search";
      seeks.robot.line_side();
      EXPECT_EQ(shown(seeks), shown(never)) << aside;
    }
  }
}

TEST(Reflectance, InTheAirASensorSeesBlackAndNoLine) {
  BenchRobot bench(reflectance_sensor(""));
  const double on_line = bench.volts(kA0);
  EXPECT_TRUE(bench.robot.sees_line());
  place_beside_line(bench, 0.03);
  EXPECT_LT(bench.volts(kA0), on_line);
  bench.body().lift(true);
  EXPECT_EQ(bench.volts(kA0), on_line);
  EXPECT_FALSE(bench.robot.sees_line());
  EXPECT_EQ(bench.robot.readings().front().value, 1.0);
}

TEST(Reflectance, ACoveredSensorSeesBlack) {
  BenchRobot bench(reflectance_sensor(""));
  place_beside_line(bench, 0.03);
  const double white = bench.volts(kA0);
  bench.robot.cover("eye", true);
  EXPECT_GT(bench.volts(kA0), 4.0);
  bench.robot.cover("eye", false);
  EXPECT_EQ(bench.volts(kA0), white);
  EXPECT_THROW(bench.robot.check_cover("ear"), InputError);
}

TEST(Reflectance, TheRobotKnowsWhetherItSeesTheLine) {
  BenchRobot bench(reflectance_sensor(""));
  EXPECT_TRUE(bench.robot.has_line_sensors());
  EXPECT_TRUE(bench.robot.sees_line());
  place_beside_line(bench, 0.03);
  EXPECT_FALSE(bench.robot.sees_line());
  place_beside_line(bench, 0.0125);
  EXPECT_TRUE(bench.robot.sees_line());
}

TEST(Reflectance, TheRobotKnowsWhetherItStraddlesTheLine) {
  const auto eye = [](const char* name, const char* pin, int y_mm) {
    return "[[part]]\ntype = \"reflectance\"\nname = \"" + std::string(name) + "\"\npin = \"" + pin +
           "\"\nat = [\"0 mm\", \"" + std::to_string(y_mm) + " mm\"]\nfootprint = \"3 mm\"\n";
  };
  BenchRobot bench(eye("left", "A0", 30) + eye("right", "A1", -30));
  const auto straddles = [&](double beside_m) {
    place_beside_line(bench, beside_m);
    return bench.robot.straddles_line(beside_m);
  };
  EXPECT_TRUE(straddles(0.0));
  EXPECT_FALSE(bench.robot.sees_line());
  EXPECT_TRUE(straddles(0.015));
  EXPECT_FALSE(straddles(0.05));
  EXPECT_FALSE(straddles(1.0));
  straddles(0.0);
  bench.body().lift(true);
  EXPECT_FALSE(bench.robot.straddles_line(0.0));
}

constexpr const char* kLamp = "+++\n[[light]]\nlevel = 0.25\n+++\n";

BenchRobot lit_bench(const std::string& keys) {
  return BenchRobot(parse_description(kBareRobot + reflectance_sensor(keys), "bench.toml"), Profile::ideal, 1,
                    kLamp);
}

TEST(RoomLight, MakesAllWhiterAndAHigherSensorMore) {
  BenchRobot low = lit_bench("white_volts = \"0.5 V\"\nblack_volts = \"4.5 V\"\n");
  EXPECT_NEAR(low.volts(kA0), 4.5 - 4.0 * 0.25, 1e-9);
  BenchRobot high = lit_bench("white_volts = \"0.5 V\"\nblack_volts = \"4.5 V\"\nheight = \"8 mm\"\n");
  EXPECT_NEAR(high.volts(kA0), 4.5 - 4.0 * 0.25 * world::exposure(0.008), 1e-9);
  EXPECT_LT(high.volts(kA0), 2.0) << "black looks nearly white";
}

TEST(RoomLight, DoesNotReachACoveredSensor) {
  BenchRobot bench = lit_bench("");
  const double lit = bench.volts(kA0);
  bench.robot.cover("eye", true);
  EXPECT_GT(bench.volts(kA0), lit + 0.5);
}

TEST(Rise, IsTheTimeFromTenToNinetyPercentBehindAnEmitterThatIsSwitched) {
  BenchRobot bench(
      reflectance_sensor("emitter = 3\nrise = \"100 us\"\nwhite_volts = \"0 V\"\nblack_volts = \"5 V\"\n"));
  place_beside_line(bench, 0.03);
  EXPECT_NEAR(bench.volts(kA0), 0.0, 1e-9);
  bench.board.output(3, false, 0);
  const double lag = 100.0 / std::log(9.0);  // time constant in us
  const auto tenth = static_cast<SimTime>(lag * std::log(1.0 / 0.9) * 1e3);
  EXPECT_NEAR(bench.board.read_volts(kA0, tenth), 0.5, 1e-3);
  EXPECT_NEAR(bench.board.read_volts(kA0, tenth + 100 * kMicrosecond), 4.5, 1e-3);
  EXPECT_NEAR(bench.board.read_volts(kA0, 900 * kMicrosecond), 5.0, 1e-3);
}

TEST(Rise, KeepsASensorBehindTheFloorThatItMovesOver) {
  const std::string motors =
      "[[part]]\nname = \"left\"\ntype = \"motor\"\npins = { in1 = 5, in2 = 6 }\n"
      "[[part]]\nname = \"right\"\ntype = \"motor\"\npins = { in1 = 9, in2 = 10 }\n";
  BenchRobot quick(reflectance_sensor("") + motors), slow(reflectance_sensor("rise = \"1 ms\"\n") + motors);
  for (BenchRobot* bench : {&quick, &slow}) {
    bench->body().place({bench->line() + Vec2{0.0, -0.025}, {0.0, 1.0}});
    bench->board.output(5, true, 0);
    bench->board.output(9, true, 0);
    while (bench->body().pose().position.y < bench->line().y - 0.009) bench->tick();
  }
  const SimTime later = quick.now + 800 * kMicrosecond, lag = 455'120;
  EXPECT_NEAR(slow.board.read_volts(kA0, later), quick.board.read_volts(kA0, later - lag), 1e-6);
  EXPECT_GT(quick.board.read_volts(kA0, later), slow.board.read_volts(kA0, later) + 0.1);
}

}  // namespace reflectance_test
}  // namespace robosim::robot
