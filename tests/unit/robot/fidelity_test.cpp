// Compares the models with published measurements. The results are the table of docs/explanation/fidelity.md
// between `<!-- ledger -->` and `<!-- end of ledger -->`. To regenerate the table, run `ROBOSIM_WRITE_DOCS=1
// robot_test --gtest_filter='Fidelity.*'`.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <numbers>

#include "hal/board/adc_capacitor.h"
#include "sim/base/file.h"
#include "sim/robot/describe.h"
#include "tests/unit/robot/bench_robot.h"

namespace robosim::robot {
namespace fidelity_test {

constexpr int kSeeds = 40;

struct Range {
  double low = 0.0, high = 0.0;
  void take(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

/// Returns the range of a value over all seeds. Each seed gives a different robot.
Range over_seeds(const std::function<double(std::uint64_t)>& figure) {
  Range range{figure(1), figure(1)};
  for (std::uint64_t seed = 2; seed <= kSeeds; ++seed) range.take(figure(seed));
  return range;
}

/// A reflectance sensor that the tests move across a line that is 15 mm wide.
class Sweep {
 public:
  Sweep(double height_mm, Profile profile, std::uint64_t seed)
      : bench_(
            parse_description(fmt::format("{}[[part]]\nname = \"eye\"\ntype = \"reflectance\"\npin = \"A0\"\n"
                                          "at = [\"0 mm\", \"0 mm\"]\nheight = \"{} mm\"\n"
                                          "white_volts = \"1 V\"\nblack_volts = \"4 V\"\n",
                                          kBareRobot, height_mm),
                              "bench.toml"),
            profile, seed, "+++\nline = \"15 mm\"\n+++\n") {}

  /// Returns the sensor's reading at `beside` m from the line's middle, without noise. The reading is 1
  /// without light. It is 0 with the light that white reflects at the sensor's best height.
  double blackness(double beside) {
    bench_.body().place({bench_.line() + Vec2{0.0, beside}, {1.0, 0.0}});
    return bench_.robot.readings().front().value;
  }
  /// Returns the distance in m from the line's middle at which the reading reaches `share`. A `share` of 0 is
  /// the reading on the line, and 1 is the reading on white.
  double reads(double share) {
    const double dark = blackness(0.0), white = blackness(0.06);
    double beside = 0.0;
    while (blackness(beside) > dark + share * (white - dark)) beside += 1e-5;
    return beside;
  }
  /// Returns the standard deviation of 1000 readings at `beside` m, as a share of the range from white to
  /// black.
  double noise(double beside) {
    bench_.body().place({bench_.line() + Vec2{0.0, beside}, {1.0, 0.0}});
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < 1000; ++i) {
      const double v = bench_.volts(kA0) / 3.0;
      sum += v;
      squares += v * v;
    }
    return std::sqrt(std::max(squares / 1000 - sum * sum / 1e6, 0.0));
  }

 private:
  BenchRobot bench_;
};

double edge_mm(double height_mm, Profile profile, std::uint64_t seed) {
  Sweep sweep(height_mm, profile, seed);
  return 1e3 * (sweep.reads(0.9) - sweep.reads(0.1));
}

double half_depth_mm(double height_mm, Profile profile, std::uint64_t seed) {
  return 2e3 * Sweep(height_mm, profile, seed).reads(0.5);
}

// Returns the light that a sensor gets from white at this height, divided by the light at the best height.
double light(double height_mm, Profile profile) { return 1.0 - Sweep(height_mm, profile, 1).blackness(0.06); }

double floor_variation(Profile profile, std::uint64_t seed) {
  const map::Map map = map::parse_map("111\n", "bench.map");
  world::World world(map);
  world.vary_floor(NoiseStream(seed, 0, "floor", "brightness"), world::typical_variation(profile));
  double sum = 0.0, squares = 0.0;
  constexpr int kPoints = 20000;
  for (int i = 0; i < kPoints; ++i) {
    const double v = world.floor().brightness({i % 141 * 7.3e-3, i / 141 * 7.3e-3});
    sum += v;
    squares += v * v;
  }
  return std::sqrt(std::max(squares / kPoints - sum * sum / kPoints / kPoints, 0.0));
}

/// An uno5 that starts from rest, with both motors at this duty cycle.
class Drive {
 public:
  Drive(Profile profile, std::uint64_t seed, double duty)
      : bench_(load_description("uno5"), profile, seed, "+++\ncell = \"600 mm\"\n+++\n") {
    bench_.body().place({bench_.line() + Vec2{-0.3, 0.0}, {1.0, 0.0}});
    for (const world::Side side : {world::left, world::right}) bench_.body().command(side, {duty, 0.0});
  }
  world::Body& body() { return bench_.body(); }
  world::Body& step() {
    bench_.world.step();
    return bench_.body();
  }

 private:
  BenchRobot bench_;
};

// Returns the time in s after which an uno5 at half the supply voltage has reached 63 % of its final speed.
double time_constant(Profile profile, std::uint64_t seed) {
  std::vector<double> speeds;
  Drive drive(profile, seed, 0.5);
  for (int tick = 0; tick < 700; ++tick) speeds.push_back(drive.step().speed());
  const auto risen = std::find_if(speeds.begin(), speeds.end(),
                                  [&](double v) { return v >= (1.0 - std::exp(-1.0)) * speeds.back(); });
  return static_cast<double>(risen - speeds.begin() + 1) * 1e-3;
}

// Returns the motor voltage that overcomes friction. At a lower voltage, the wheel does not turn.
double bias(Profile profile, std::uint64_t seed) {
  const world::WheelParams wheel = body_params(load_description("uno5"), seed, profile).wheel[0];
  return wheel.no_load_current * wheel.nominal_volts / wheel.stall_current;
}

// Returns the relative difference between the wheels' radii.
double wheel_mismatch(Profile profile, std::uint64_t seed) {
  const world::BodyParams p = body_params(load_description("uno5"), seed, profile);
  return std::abs(p.wheel[0].radius_m / p.wheel[1].radius_m - 1.0);
}

/// A lifted micromouse. Its motors have the maker's parameters with the spreads of uno5. Its DRV8833 gets
/// pulses on one input, so the motors coast between the pulses.
class Lifted {
 public:
  Lifted(Profile profile, std::uint64_t seed)
      : bench_(parse_description(R"(board = "nano"
[chassis]
outline = { radius = "50 mm" }
mass = "150 g"
track = "80 mm"
wheel = "32 mm"
[motors]
voltage = "12 V"
no_load = { value = "1100 rpm", spread = "5 %" }
no_load_current = { value = "80 mA", spread = "10 %" }
stall_torque = { value = "38 mN m", spread = "5 %" }
stall_current = { value = "0.75 A", spread = "5 %" }
gear = 29.861
supply = "7.45 V"
[driver]
chip = "drv8833"
[[part]]
name = "left"
type = "motor"
pins = { in1 = 5, in2 = 6 }
)",
                                 "micromouse.toml"),
               profile, seed) {
    bench_.body().lift(true);
  }
  /// Returns the left wheel's rate in rad/s after 1 s at this duty cycle.
  double rate_at(double duty) {
    bench_.board.pwm(5, duty, bench_.now);
    bench_.ticks(1000);
    return bench_.body().wheel_rate(world::left);
  }

 private:
  BenchRobot bench_;
};

double lifted_rate(Profile profile, std::uint64_t seed, double duty) {
  return Lifted(profile, seed).rate_at(duty);
}

// Returns the least duty cycle at which a resting wheel starts. If `from_rest` is false, returns the duty
// cycle at which a turning wheel stops. The duty cycle changes in steps of 1 / 255.
double least_duty(Profile profile, std::uint64_t seed, bool from_rest) {
  Lifted mouse(profile, seed);
  if (from_rest) {
    for (int step = 40;; ++step)
      if (mouse.rate_at(step / 255.0) > 1.0) return step / 255.0;
  }
  for (int step = 85;; --step)
    if (mouse.rate_at(step / 255.0) < 1.0) return step / 255.0;
}

// Returns the sideways deviation in m after 1 m. The robot drives along a circle, because its wheels turn
// equally but have different radii.
double aside(Profile profile, std::uint64_t seed) {
  return 0.5 * wheel_mismatch(profile, seed) / body_params(load_description("uno5"), seed, profile).track_m;
}

// Returns the ratio of the distance that the wheels measure to the true distance, at this duty cycle.
double way_by_wheels(Profile profile, std::uint64_t seed, double duty) {
  Drive drive(profile, seed, duty);
  double travel = 0.0, distance = 0.0;
  for (int tick = 0; tick < 1500; ++tick) {
    if (tick == 500) {
      travel = drive.body().wheel_travel();
      distance = drive.body().distance();
    }
    drive.step();
  }
  return (drive.body().wheel_travel() - travel) / (drive.body().distance() - distance);
}

// Returns the relative difference between way_by_wheels() at two duty cycles.
double creep(Profile profile, std::uint64_t seed, double slow, double fast) {
  const double more = std::abs(way_by_wheels(profile, seed, fast) / way_by_wheels(profile, seed, slow) - 1.0);
  return more < 1e-9 ? 0.0 : more;  // rounding error
}

// Returns the distance in m that the robot rolls from 0.5 m/s. If `brakes` is true, the motors are shorted.
// If it is false, they are open.
double stops_within(Profile profile, std::uint64_t seed, bool brakes) {
  Drive drive(profile, seed, 0.6);
  while (drive.body().speed() < 0.5) drive.step();
  const double distance = drive.body().distance();
  for (const world::Side side : {world::left, world::right})
    drive.body().command(side, {0.0, brakes ? 1.0 : 0.0});
  while (drive.body().speed() > 1e-4) drive.step();
  return drive.body().distance() - distance;
}

// Returns the effective track width of a robot that turns on the spot, divided by the real track width. The
// robot has two wheels per side.
double effective_track(Profile profile, std::uint64_t seed, double track_mm, double wheelbase_mm) {
  BenchRobot bench(
      parse_description(fmt::format("base = \"rover5\"\n[chassis]\ntrack = \"{} mm\"\nwheelbase = "
                                    "\"{} mm\"\nwheel = \"32 mm\"\n",
                                    track_mm, wheelbase_mm),
                        "rover.toml"),
      profile, seed);
  bench.body().command(world::left, {-0.7, 0.0});
  bench.body().command(world::right, {0.7, 0.0});
  for (int tick = 0; tick < 1000; ++tick) bench.world.step();
  return (bench.body().tread_speed(world::right) - bench.body().tread_speed(world::left)) /
         bench.body().turn_rate() / (1e-3 * track_mm);
}

// Returns the voltage drop of an L298N at one ampere.
double l298n_volts(Profile profile, std::uint64_t seed) {
  std::string robot = kBareRobot;
  robot.replace(robot.find("tb6612"), 6, "l298n");
  const world::BodyParams p = body_params(parse_description(robot, "bench.toml"), seed, profile);
  return p.driver_drop_volts + p.driver_ohms;
}

// Returns the time in s in which a lifted wheel reaches 63 % of its final speed.
double lifted_time_constant(Profile profile, std::uint64_t seed) {
  Drive drive(profile, seed, 0.5);
  drive.body().lift(true);
  std::vector<double> rates;
  for (int tick = 0; tick < 700; ++tick) rates.push_back(drive.step().wheel_rate(world::left));
  const auto risen = std::find_if(rates.begin(), rates.end(),
                                  [&](double w) { return w >= (1.0 - std::exp(-1.0)) * rates.back(); });
  return static_cast<double>(risen - rates.begin() + 1) * 1e-3;
}

// Returns the relative error of an MPU-6050's turn rate while the robot turns.
double gyro_error(Profile profile, std::uint64_t seed) {
  BenchRobot bench("[[part]]\nname = \"imu\"\ntype = \"mpu-6050\"\nbias = \"0 deg/s\"\n", profile, seed);
  bench.body().command(world::left, {-0.5, 0.0});
  bench.body().command(world::right, {0.5, 0.0});
  for (int tick = 0; tick < 300; ++tick) bench.world.step();
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  return std::abs(bench.robot.readings().front().value / (bench.body().turn_rate() * kDegrees) - 1.0);
}

double alkaline_ohms(Profile profile, std::uint64_t) {
  const Description robot = parse_description(
      "base = \"uno5\"\n[battery]\nkind = \"alkaline\"\ncells = 4\ncapacity_mAh = 2000\n", "robot.toml");
  return robot.battery.resistance.in(profile).value / robot.battery.cells;
}

// Discharges a fresh alkaline cell of 2 Ah. The current rises by 0.05 A every 20 s. Returns the highest
// current in A at which the cell still has 1 V.
double alkaline_amps(Profile profile, std::uint64_t seed) {
  const double ohms = alkaline_ohms(profile, seed), capacity = 2000.0 * 3.6;
  const Description robot = parse_description(
      "base = \"uno5\"\n[battery]\nkind = \"alkaline\"\ncells = 1\ncapacity_mAh = 2000\n", "robot.toml");
  const Cells cell{robot.battery.kind, 1.0, ohms, capacity, 0.0};
  double charge = 1.0, amps = 0.0;
  while (charge > 0.0 && cell.rest_volts(charge) - (amps + 0.05) * ohms >= 1.0) {
    amps += 0.05;
    charge -= amps * 20.0 / capacity;
  }
  return amps;
}

// Returns the share of the previous channel's voltage that remains on the ADC's capacitor. The new channel
// charges the capacitor for 12 or 20 us.
double channel_before(double source_ohms, std::uint64_t seed) {
  AdcCapacitor capacitor{1.0};
  capacitor.charge({0.0, source_ohms}, seed % 2 ? 12e-6 : 20e-6);
  return capacitor.volts;
}

struct Figure {
  const char* what;
  const char* unit;
  double scale;
  Range measured;
  const char* source;  ///< "" if no published value was found
  std::function<double(Profile, std::uint64_t)> ours;
  const char* why_not;  ///< why the simulated value is outside of the measured range; "" if it is inside
};

const std::vector<Figure>& figures() {
  const auto by_height = [](double height_mm) {
    return [height_mm](Profile profile, std::uint64_t) { return light(height_mm, profile); };
  };
  const auto wheel = [](double world::WheelParams::*figure) {
    return [figure](Profile profile, std::uint64_t seed) {
      return body_params(load_description("uno5"), seed, profile).wheel[0].*figure;
    };
  };
  constexpr double kRpm = 2.0 * std::numbers::pi / 60.0;
  constexpr double kKgCm = 0.0980665;
  static const std::vector<Figure> all = {
      {"edge of a 15 mm tape, 10 to 90 %, sensor 12 mm high",
       "mm",
       1.0,
       {8.3, 10.3},
       "RobiAnalysis, robot 0",
       [](Profile p, std::uint64_t s) { return edge_mm(12, p, s); },
       ""},
      {"the same edge, sensor 8 mm high",
       "mm",
       1.0,
       {1.6, 2.2},
       "RobiAnalysis, robot 1",
       [](Profile p, std::uint64_t s) { return edge_mm(8, p, s); },
       ""},
      {"width of this tape at half depth, sensor 12 mm high",
       "mm",
       1.0,
       {15.7, 18.7},
       "RobiAnalysis, robot 0",
       [](Profile p, std::uint64_t s) { return half_depth_mm(12, p, s); },
       "the model sees the tape's true width; the measured sensor sees it 0.7 to 3.7 mm wider"},
      {"the same width, sensor 8 mm high",
       "mm",
       1.0,
       {14.2, 15.1},
       "RobiAnalysis, robot 1",
       [](Profile p, std::uint64_t s) { return half_depth_mm(8, p, s); },
       ""},
      {"light from white at 1 mm, relative to the best height",
       "",
       1.0,
       {0.82, 0.84},
       "TCRT5000, fig. 9",
       by_height(1),
       ""},
      {"the same light at 5 mm", "", 1.0, {0.77, 0.79}, "TCRT5000, fig. 9", by_height(5), ""},
      {"the same light at 8 mm", "", 1.0, {0.47, 0.49}, "TCRT5000, fig. 9", by_height(8), ""},
      {"the same light at 12 mm", "", 1.0, {0.26, 0.28}, "TCRT5000, fig. 9", by_height(12), ""},
      {"noise of a reading over white, relative to white to black",
       "%",
       100.0,
       {0.007, 0.016},
       "RobiAnalysis",
       [](Profile p, std::uint64_t s) { return Sweep(3, p, s).noise(0.06); },
       ""},
      {"noise over black, relative to noise over white",
       "",
       1.0,
       {0.28, 0.74},
       "RobiAnalysis",
       [](Profile p, std::uint64_t s) { return Sweep(3, p, s).noise(0.0) / Sweep(3, p, s).noise(0.06); },
       ""},
      {"brightness of a white floor, standard deviation",
       "%",
       100.0,
       {0.045, 0.056},
       "RobiAnalysis, robot 0",
       floor_variation,
       ""},
      {"the same brightness, another floor",
       "%",
       100.0,
       {0.12, 0.18},
       "RobiAnalysis, robot 1",
       floor_variation,
       "floors differ by a factor of three; for this one, set `variation = \"15 %\"` in the map"},
      {"no-load speed of a 50:1 HP motor at 6 V",
       "rpm",
       1.0 / kRpm,
       {640 * kRpm, 660 * kRpm},
       "Pololu, HPCB 50:1",
       wheel(&world::WheelParams::no_load_rate),
       ""},
      {"stall torque of this motor",
       "kg cm",
       1.0 / kKgCm,
       {0.72 * kKgCm, 0.76 * kKgCm},
       "Pololu, HPCB 50:1",
       wheel(&world::WheelParams::stall_torque),
       ""},
      {"stall current of this motor",
       "A",
       1.0,
       {1.47, 1.53},
       "Pololu, HPCB 50:1",
       wheel(&world::WheelParams::stall_current),
       ""},
      {"motor voltage that overcomes friction",
       "V",
       1.0,
       {0.12, 0.34},
       "UKMARS, 4 motors",
       bias,
       "the model uses the no-load current of that motor's data sheet, at 6 V and 1.5 A stall; UKMARS used "
       "other motors"},
      {"speed of a lifted wheel at 98 % duty cycle, 30:1 HPCB 12 V motor, DRV8833 at 7.45 V",
       "rpm",
       1.0 / kRpm,
       {573 * kRpm, 655 * kRpm},
       "opatiny, 2 motors, both ways",
       [](Profile p, std::uint64_t s) { return lifted_rate(p, s, 250.0 / 255.0); },
       ""},
      {"the same speed at 47 % duty cycle",
       "rpm",
       1.0 / kRpm,
       {419 * kRpm, 507 * kRpm},
       "opatiny",
       [](Profile p, std::uint64_t s) { return lifted_rate(p, s, 120.0 / 255.0); },
       ""},
      {"duty cycle at which this wheel stops",
       "%",
       100.0,
       {40.0 / 255.0, 45.0 / 255.0},
       "opatiny",
       [](Profile p, std::uint64_t s) { return least_duty(p, s, false); },
       ""},
      {"duty cycle at which this wheel starts",
       "%",
       100.0,
       {35.0 / 255.0, 75.0 / 255.0},
       "opatiny",
       [](Profile p, std::uint64_t s) { return least_duty(p, s, true); },
       ""},
      {"time constant of a driving robot",
       "ms",
       1e3,
       {0.095, 0.210},
       "shimotoriharuki, UKMARS orion",
       time_constant,
       ""},
      {"time constant of a lifted wheel",
       "ms",
       1e3,
       {0.029, 0.035},
       "UKMARS, motorlab",
       lifted_time_constant,
       "they measured a 10:1 motor without a wheel; the model has a 50:1 motor with its wheel"},
      {"voltage drop of an L298N at 1 A", "V", 1.0, {1.8, 3.2}, "ST, L298", l298n_volts, ""},
      {"distance from 0.5 m/s to rest, motors open",
       "mm",
       1e3,
       {},
       "",
       [](Profile p, std::uint64_t s) { return stops_within(p, s, false); },
       "no published measurement found"},
      {"distance from 0.5 m/s to rest, motors shorted",
       "mm",
       1e3,
       {},
       "",
       [](Profile p, std::uint64_t s) { return stops_within(p, s, true); },
       "no published measurement found"},
      {"sideways drift within 1 m, wheels that turn equally",
       "mm",
       1e3,
       {0.031, 0.051},
       "UKMARS, by its wheels",
       aside,
       ""},
      {"difference of two laps, measured by the wheels",
       "%",
       100.0,
       {0.0, 0.0003},
       "shimotoriharuki, at 1.0 m/s",
       [](Profile p, std::uint64_t s) { return creep(p, s, 0.4, 0.4); },
       ""},
      {"growth of this lap at a third more speed",
       "%",
       100.0,
       {0.027, 0.029},
       "shimotoriharuki, at 1.3 m/s",
       [](Profile p, std::uint64_t s) { return creep(p, s, 0.4, 0.5); },
       "modelled tyres do not creep (see below)"},
      {"error of an angle by a gyroscope, uncalibrated",
       "%",
       100.0,
       {0.0, 0.03},
       "InvenSense, MPU-6050, 6.1",
       gyro_error,
       ""},
      {"a skidding robot's effective track width, divided by its own; track 376 mm, wheelbase 262 mm",
       "",
       1.0,
       {1.45, 1.55},
       "Clearpath, Jackal",
       [](Profile p, std::uint64_t s) { return effective_track(p, s, 93.9, 65.5); },
       ""},
      {"the same ratio; track 571 mm, wheelbase 512 mm",
       "",
       1.0,
       {1.87, 1.88},
       "Clearpath, Husky",
       [](Profile p, std::uint64_t s) { return effective_track(p, s, 142.7, 128.0); },
       "4 % less; they use one value for all floors and speeds, for wide soft tyres"},
      {"resistance of a fresh alkaline AA cell",
       "ohm",
       1.0,
       {0.15, 0.30},
       "Energizer, E91",
       alkaline_ohms,
       ""},
      {"current at which this cell sinks to 1 V; it grows by 0.05 A every 20 s",
       "A",
       1.0,
       {1.70, 1.75},
       "rightbattery, Duracell Procell",
       alkaline_amps,
       "a third more: under minutes of load, a cell's chemistry adds some 0.1 ohm, which the model lacks; "
       "motors' peaks are shorter"},
      {"share of the previous channel that `analogRead()` on an Uno still reads, 10 kohm at the pin",
       "%",
       100.0,
       {0.0, 0.0005},
       "Microchip, ATmega328P, 24.6.1",
       [](Profile, std::uint64_t s) { return channel_before(10e3, s); },
       ""},
      {"the same share, 1 Mohm",
       "%",
       100.0,
       {},
       "",
       [](Profile, std::uint64_t s) { return channel_before(1e6, s); },
       "no published measurement found"},
      {"difference between the wheels' radii",
       "%",
       100.0,
       {0.0047, 0.0077},
       "UKMARS orion, osmium",
       wheel_mismatch,
       ""},
  };
  return all;
}

std::string number(double x, double scale) {
  const double shown = x * scale;
  return shown == 0.0 ? "0"
                      : fmt::format("{:.{}f}", shown,
                                    std::abs(shown) < 0.1  ? 3
                                    : std::abs(shown) < 10 ? 2
                                                           : 0);
}

std::string range(Range r, const Figure& figure) {
  const std::string low = number(r.low, figure.scale), high = number(r.high, figure.scale);
  return (low == high ? low : low + " … " + high) + (*figure.unit ? " " : "") + figure.unit;
}

bool meet(Range a, Range b) { return a.low <= b.high && b.low <= a.high; }

TEST(Fidelity, TheLedgerSaysWhatOursAreAndWhyAnyIsOff) {
  std::string table =
      "| value | measured | by | `typical@1` | `typical@2` | agreement |\n|---|---|---|---|---|---|\n";
  for (const Figure& figure : figures()) {
    const auto in = [&](Profile profile) {
      return over_seeds([&](std::uint64_t seed) { return figure.ours(profile, seed); });
    };
    const Range now = in(Profile::typical_2);
    const bool found = *figure.source, within = found && meet(now, figure.measured);
    EXPECT_EQ(within, !*figure.why_not) << figure.what << ": ours is " << range(now, figure) << ", measured "
                                        << range(figure.measured, figure);
    table += fmt::format("| {} | {} | {} | {} | {} | {} |\n", figure.what,
                         found ? range(figure.measured, figure) : "–", found ? figure.source : "–",
                         range(in(Profile::typical_1), figure), range(now, figure),
                         within ? "within" : figure.why_not);
  }
  const std::filesystem::path file =
      std::filesystem::path(ROBOSIM_SOURCE_DIR) / "docs/explanation/fidelity.md";
  const std::string page = read_file(file);
  const std::string begin = "<!-- ledger -->\n\n", end = "\n<!-- end of ledger -->";
  const std::size_t from = page.find(begin), to = page.find(end);
  ASSERT_NE(from, std::string::npos);
  ASSERT_NE(to, std::string::npos);
  const std::string wanted = page.substr(0, from + begin.size()) + table + page.substr(to);
  if (std::getenv("ROBOSIM_WRITE_DOCS")) write_file(file, wanted);
  EXPECT_EQ(read_file(file), wanted) << "regenerate it with ROBOSIM_WRITE_DOCS=1 and this test";
}

}  // namespace fidelity_test
}  // namespace robosim::robot
