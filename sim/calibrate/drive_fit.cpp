#include "sim/calibrate/drive_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/base/error.h"
#include "sim/calibrate/optimise.h"
#include "sim/robot/describe.h"
#include "sim/robot/parts/encoder.h"
#include "sim/robot/parts/motor.h"
#include "sim/world/world.h"

namespace robosim::calibrate {
namespace {

constexpr double kTick = 0.001;      // s, of the world
constexpr double kAlike = 10.0;      // samples that say as much as one
constexpr double kMostUnsure = 0.5;  // of a figure's logarithm: beyond, the data do not tell it
// What ticks, and the duty of a PWM that is known to half a step, add: standard deviations, as shares.
constexpr double kSpeedModel = 0.005, kForceModel = 0.02;
constexpr double kPiece =
    0.5;  // s: of a longer drive each such piece is looked at by itself, for errors of its place grow
constexpr double kRollsFor = 5.0;  // s at most, behind a timed drive
constexpr int kMostCalls = 500;

/// What is fitted or held: factors of the file's figures, as logarithms.
enum Factor {
  no_load_left,
  no_load_right,
  torque,
  friction,
  inertia,
  supply,
  mass,
  stall,
  rolling,
  kFactors
};
using Factors = std::array<double, kFactors>;

/// The same robot without spreads, as typical@2 has it.
robot::Description nominal(robot::Description robot) {
  robot::Chassis& c = robot.chassis;
  robot::Motors& m = robot.motors;
  robot::Driver& d = robot.driver;
  for (robot::Number* n : {&c.mass,         &c.inertia,       &c.load_share,
                           &c.track,        &c.wheel,         &c.wheel_inertia,
                           &c.grip,         &c.rolling,       &c.wall_friction,
                           &m.voltage,      &m.no_load,       &m.no_load_current,
                           &m.stall_torque, &m.stall_current, &m.static_friction,
                           &m.gear,         &m.rotor_inertia, &m.supply,
                           &d.drop,         &d.resistance})
    *n = {n->in(Profile::typical_2).value, 0.0};
  return robot;
}

/// The share of a figure that its spread in the file is, as a standard deviation.
double held_sd(const robot::Number& number) {
  const robot::Spread now = number.in(Profile::typical_2);
  return now.value > 0.0 ? now.spread / (now.value * std::numbers::sqrt3) : 0.0;
}

world::BodyParams with(world::BodyParams body, const Factors& x) {
  for (const int side : {0, 1}) {
    world::WheelParams& wheel = body.wheel[side];
    wheel.no_load_rate *= std::exp(x[static_cast<std::size_t>(side)]);
    wheel.stall_torque *= std::exp(x[torque]);
    wheel.no_load_current *= std::exp(x[friction]);
    wheel.stall_current *= std::exp(x[stall]);
    wheel.no_load_current = std::min(wheel.no_load_current, 0.7 * wheel.stall_current);
  }
  body.yaw_inertia_kgm2 *= std::exp(x[inertia]);
  body.supply_volts *= std::exp(x[supply]);
  body.mass_kg *= std::exp(x[mass]);
  body.rolling_resistance *= std::exp(x[rolling]);
  return body;
}

/// What a motor gets when the sketch says -255 .. 255. 0 is all pins low.
world::WheelCommand command(const robot::Description& robot, const robot::MotorSpec& motor, int told) {
  if (told == 0) return {0.0, 0.0};
  // Between (n + 1) / 256 of an Uno's timer 0 and n / 255 of the others.
  const double duty = std::abs(told) == 255 ? 1.0 : (std::abs(told) + 0.5) / 255.5;
  robot::BridgeInputs inputs;
  inputs.phase = motor.phase;
  if (motor.en != kNoPin) {
    inputs.en = duty;
    inputs.in1 = 1.0;
  } else {
    inputs.in1 = duty;
  }
  world::WheelCommand forward = robot::bridge_command(*robot.driver.chip, inputs);
  forward.drive = std::copysign(forward.drive, told);
  return forward;
}

const robot::MotorSpec* motor_of(const robot::Description& robot, int side) {
  for (const auto& part : robot.parts)
    if (const auto* motor = dynamic_cast<const robot::MotorSpec*>(part.get()); motor && motor->wheel == side)
      return motor;
  return nullptr;
}

class Bench {
 public:
  Bench(const std::vector<Log>& logs, const std::vector<Timed>& timed, const robot::Description& robot,
        double volts)
      : logs_(logs),
        timed_(timed),
        robot_(nominal(robot)),
        body_(robot::body_params(robot_, 1, Profile::typical_2)) {
    if (volts > 0.0) body_.supply_volts = volts;
    for (const int side : {0, 1}) {
      // A file that has no friction gets some to begin with.
      world::WheelParams& wheel = body_.wheel[side];
      wheel.no_load_current = std::max(wheel.no_load_current, 0.03 * wheel.stall_current);
      motors_[side] = motor_of(robot_, side);
    }
    floor_.width = floor_.height = 40;
    floor_.cell_m = 1.0;
    floor_.cells.assign(1600, grid::Cell::floor);
  }

  const world::BodyParams& body() const { return body_; }
  bool has_motors() const { return motors_[0] && motors_[1]; }

  /// Throws InputError for drives that no figures make.
  void check() {
    for (const Log& log : logs_) {
      if (log.drives.empty()) continue;
      for (const int side : {0, 1}) per_turn_[side] = counts_per_turn(log, side);
      for (const Drive& drive : log.drives) {
        spins_ = spins_ || drive.told[0].front() * drive.told[1].front() < 0;
        for (const std::size_t side : {0u, 1u}) check(log, drive, side);
      }
    }
  }
  bool spins() const { return spins_; }

  /// The residuals, each over what it is uncertain by.
  std::vector<double> residuals(const Factors& x, std::vector<DriveCurve>* curves = nullptr) const {
    std::vector<double> all;
    world::World world(floor_);
    world.add_body(with(body_, x), {{20.0, 20.0}, {1.0, 0.0}});
    for (const Log& log : logs_)
      for (const Drive& drive : log.drives) follow(world, drive, all, curves);
    for (const Timed& timed : timed_) all.push_back((drive_timed(world, timed) - timed.distance) / timed.sd);
    return all;
  }

 private:
  double counts_per_turn(const Log& log, int side) const {
    for (const auto& part : robot_.parts)
      if (const auto* encoder = dynamic_cast<const robot::EncoderSpec*>(part.get());
          encoder && encoder->wheel == side) {
        if (!log.counts_per_period)
          throw InputError({log.file},
                           "counts edges, but does not say how many in each period of a channel; put "
                           "“# counts_per_period = 2” before its tables (1: rising edges, 2: both)");
        return encoder->periods * *log.counts_per_period;
      }
    throw InputError({log.file, log.drives.front().line},
                     fmt::format("this drive has counts, but the robot file has no encoder on the {} wheel",
                                 side == 0 ? "left" : "right"));
  }

  void check(const Log& log, const Drive& drive, std::size_t side) const {
    const char* name = side == 0 ? "left" : "right";
    const int told = drive.told[side].front();
    double counted = 0.0, along = 0.0;  // in all, and as told
    for (std::size_t i = 1; i < drive.t.size(); ++i) {
      const double more = drive.count[side][i] - drive.count[side][i - 1];
      counted += more;
      along += more * drive.told[side][i - 1];
    }
    const Place place{log.file, drive.line};
    if (told == 0)
      throw InputError({log.file, drive.lines.front()},
                       fmt::format("{} is 0 in the first row; a drive begins "
                                   "with what the motors are told",
                                   name));
    if (std::fabs(along) < 5.0 * std::abs(told))
      throw InputError(
          place,
          fmt::format("the {} motor is told {}, but its encoder counts {:.0f}: it does not turn, or its "
                      "encoder does not count",
                      name, told, counted));
    if (along < 0.0)
      throw InputError(place,
                       fmt::format("the {} motor is told {}, but its encoder counts {:.0f}: its leads or the "
                                   "encoder's channels are swapped",
                                   name, told, counted));
  }

  void follow(world::World& world, const Drive& drive, std::vector<double>& all,
              std::vector<DriveCurve>* curves) const {
    world::Body& body = world.body(0);
    body.place({{20.0, 20.0}, {1.0, 0.0}});
    const double start[2] = {body.wheel_angle(world::left), body.wheel_angle(world::right)};
    std::array<std::vector<double>, 2> angles;
    std::size_t row = 0, sample = 0;
    for (double now = drive.t.front(); sample < drive.t.size(); now += kTick) {
      while (sample < drive.t.size() && drive.t[sample] < now + kTick) {  // rates are constant within a tick
        for (const world::Side side : {world::left, world::right})
          angles[side].push_back(body.wheel_angle(side) - start[side] +
                                 body.wheel_rate(side) * (drive.t[sample] - now));
        ++sample;
      }
      world::WheelCommand mean[2];
      for (double from = now; from < now + kTick;) {
        const double to = row + 1 < drive.t.size() ? std::min(drive.t[row + 1], now + kTick) : now + kTick;
        for (const int side : {0, 1}) {
          const world::WheelCommand told =
              command(robot_, *motors_[side], drive.told[static_cast<std::size_t>(side)][row]);
          mean[side].drive += told.drive * (to - from) / kTick;
          mean[side].brake += told.brake * (to - from) / kTick;
        }
        from = to;
        if (row + 1 < drive.t.size() && to >= drive.t[row + 1]) ++row;
      }
      body.command(world::left, mean[0]);
      body.command(world::right, mean[1]);
      world.step();
    }
    DriveCurve curve{drive.t, {}, {}, {drive.told[0].front(), drive.told[1].front()}};
    for (const std::size_t side : {0u, 1u}) {
      std::vector<double> errors;
      double sum = 0.0;
      for (std::size_t i = 0; i < drive.t.size(); ++i) {
        errors.push_back(drive.count[side][i] - drive.count[side].front() -
                         angles[side][i] / (2.0 * std::numbers::pi) * per_turn_[side]);
        sum += errors.back();
      }
      const double phase = std::clamp(sum / static_cast<double>(errors.size()), -1.0, 1.0);
      for (std::size_t first = 0; first < errors.size();) {
        std::size_t last = first;
        double drift = 0.0;
        for (; last < errors.size() && (last - first < 5 || drive.t[last] < drive.t[first] + kPiece); ++last)
          drift += errors[last];
        drift = first == 0 ? std::clamp(drift / static_cast<double>(last - first), -1.0, 1.0)
                           : drift / static_cast<double>(last - first);
        for (; first < last; ++first) all.push_back(errors[first] - drift);
      }
      if (!curves) continue;
      for (std::size_t i = 0; i < drive.t.size(); ++i) {
        curve.measured[side].push_back((drive.count[side][i] - drive.count[side].front()) / per_turn_[side]);
        curve.fitted[side].push_back(angles[side][i] / (2.0 * std::numbers::pi) + phase / per_turn_[side]);
      }
    }
    if (curves) curves->push_back(std::move(curve));
  }

  double drive_timed(world::World& world, const Timed& timed) const {
    world::Body& body = world.body(0);
    body.place({{2.0, 20.0}, {1.0, 0.0}});
    const double before = body.distance();
    const int ticks = static_cast<int>(std::lround(timed.seconds / kTick));
    for (int tick = 0; tick < ticks + static_cast<int>(kRollsFor / kTick); ++tick) {
      for (const int side : {0, 1})
        body.command(static_cast<world::Side>(side),
                     command(robot_, *motors_[side], tick < ticks ? timed.told : 0));
      world.step();
      if (tick > ticks && body.speed() == 0.0) break;
    }
    return body.distance() - before;
  }

  const std::vector<Log>& logs_;
  const std::vector<Timed>& timed_;
  const robot::Description robot_;
  world::BodyParams body_;
  const robot::MotorSpec* motors_[2] = {};
  double per_turn_[2] = {};
  bool spins_ = false;
  grid::Map floor_;
};

double sum_of_squares(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return sum;
}

/// The covariance of those that are free and those that are held with `held` as their standard deviations.
std::vector<std::vector<double>> covariance(const Bench& bench, const Factors& x, const std::vector<int>& all,
                                            const Factors& held, double variance) {
  constexpr double kStep = 0.01;
  std::vector<std::vector<double>> slopes;
  for (const int figure : all) {
    Factors above = x, below = x;
    above[static_cast<std::size_t>(figure)] += kStep;
    below[static_cast<std::size_t>(figure)] -= kStep;
    std::vector<double> slope = bench.residuals(above);
    const std::vector<double> low = bench.residuals(below);
    for (std::size_t i = 0; i < slope.size(); ++i) slope[i] = (slope[i] - low[i]) / (2.0 * kStep);
    slopes.push_back(std::move(slope));
  }
  std::vector<std::vector<double>> information(all.size(), std::vector<double>(all.size(), 0.0));
  for (std::size_t a = 0; a < all.size(); ++a) {
    for (std::size_t b = 0; b < all.size(); ++b)
      for (std::size_t i = 0; i < slopes[a].size(); ++i)
        information[a][b] += slopes[a][i] * slopes[b][i] / variance;
    const double sd = held[static_cast<std::size_t>(all[a])];
    information[a][a] += sd > 0.0 ? 1.0 / (sd * sd) : 1e-6;
  }
  return inverse(information);
}

}  // namespace

std::optional<DriveFit> fit_drives(const std::vector<Log>& logs, const std::vector<Timed>& timed,
                                   const robot::Description& robot, Found measured_supply) {
  const bool counted =
      std::any_of(logs.begin(), logs.end(), [](const Log& log) { return !log.drives.empty(); });
  if (!counted && timed.empty()) return std::nullopt;
  Bench bench(logs, timed, robot, measured_supply.value);
  if (!bench.has_motors())
    throw InputError({robot.file.string()},
                     "has no part of type motor on each wheel, and drives are of motors");
  bench.check();

  std::vector<int> free{no_load_left};
  if (counted) free.push_back(no_load_right);
  if (counted || timed.size() >= 2) free.push_back(friction);
  if (counted || timed.size() >= 3) free.push_back(torque);
  if (bench.spins()) free.push_back(inertia);
  std::vector<Range> ranges;
  for (const int figure : free)
    ranges.push_back(figure == friction ? Range{-4.0, 2.5, 0.0, 0.3} : Range{-2.5, 2.5, 0.0, 0.15});
  const auto factors = [&](const std::vector<double>& values) {
    Factors x{};
    for (std::size_t i = 0; i < free.size(); ++i) x[static_cast<std::size_t>(free[i])] = values[i];
    if (!counted) x[no_load_right] = x[no_load_left];
    return x;
  };
  const Factors x = factors(minimise(
      [&](const std::vector<double>& values) { return sum_of_squares(bench.residuals(factors(values))); },
      ranges, kMostCalls));

  DriveFit fit;
  const std::vector<double> left = bench.residuals(x, &fit.curves);
  const double samples = static_cast<double>(left.size());
  const double spare = std::max(samples - static_cast<double>(free.size()), 1.0);
  fit.rms = std::sqrt(sum_of_squares(left) / samples);
  const double variance =
      counted ? kAlike * sum_of_squares(left) / spare : std::max(sum_of_squares(left) / spare, 1.0);

  Factors held{};
  held[supply] =
      measured_supply.value > 0.0 ? measured_supply.sd / measured_supply.value : held_sd(robot.motors.supply);
  held[mass] = held_sd(robot.chassis.mass);
  held[stall] = held_sd(robot.motors.stall_current);
  held[rolling] = held_sd(robot.chassis.rolling);
  std::vector<int> all = free;
  for (const int figure : {supply, mass, stall, rolling})
    if (held[static_cast<std::size_t>(figure)] > 0.0) all.push_back(figure);
  const auto spread = covariance(bench, x, all, held, variance);
  const auto sd_of = [&](int figure) {
    const auto place = std::find(all.begin(), all.end(), figure);
    if (spread.empty() || place == all.end()) return 10.0 * kMostUnsure;
    const auto i = static_cast<std::size_t>(place - all.begin());
    return std::sqrt(std::max(spread[i][i], 0.0));
  };
  const world::BodyParams body = with(bench.body(), x);
  const auto found = [&](double value, int figure) {
    return Found{value,
                 value * std::hypot(sd_of(figure), figure <= no_load_right ? kSpeedModel : kForceModel)};
  };
  fit.no_load = {found(body.wheel[0].no_load_rate, no_load_left),
                 found(body.wheel[1].no_load_rate, counted ? no_load_right : no_load_left)};
  fit.stall_torque = found(body.wheel[0].stall_torque, torque);
  fit.no_load_current = found(body.wheel[0].no_load_current, friction);
  if (bench.spins() && sd_of(inertia) < kMostUnsure) fit.inertia = found(body.yaw_inertia_kgm2, inertia);
  fit.torque_told = sd_of(torque) < kMostUnsure;
  fit.friction_told = sd_of(friction) < kMostUnsure;

  const world::WheelParams& w = body.wheel[0];
  const double ohms = w.nominal_volts / w.stall_current;
  const double k_t = w.stall_torque / (w.stall_current - w.no_load_current);
  const double k_e =
      (w.nominal_volts - ohms * w.no_load_current) / (0.5 * (w.no_load_rate + body.wheel[1].no_load_rate));
  const double turning = w.wheel_inertia_kgm2 + w.rotor_inertia_kgm2 * w.gear_ratio * w.gear_ratio +
                         0.5 * body.mass_kg * w.radius_m * w.radius_m;
  const double tau = turning * (ohms + body.driver_ohms) / (k_t * k_e);
  fit.time_constant = {tau, tau * (counted ? 0.02 : 0.1)};
  return fit;
}

}  // namespace robosim::calibrate
