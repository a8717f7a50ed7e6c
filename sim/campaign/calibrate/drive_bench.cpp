#include "sim/campaign/calibrate/drive_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/base/error.h"
#include "sim/robot/describe.h"
#include "sim/robot/parts/encoder.h"

namespace robosim::calibrate {
namespace {

constexpr double kTick = 0.001;         // s, tick of the world
constexpr double kPiece = 0.5;          // s, duration of the pieces in which a drive is compared
constexpr double kRollsFor = 5.0;       // s, maximum time of rolling after a timed drive
constexpr double kMostDriving = 120.0;  // s, maximum total of all drives
constexpr double kCell = 50.0;          // m, side of a cell: no wall is near the robot
const Pose kStart{{20.0 * kCell, 20.0 * kCell}, {1.0, 0.0}};

/// Returns the robot with the parameters of the profile typical@2, without their spread.
robot::Description nominal(robot::Description robot) {
  robot::Chassis& c = robot.chassis;
  robot::Motors& m = robot.motors;
  robot::Driver& d = robot.driver;
  for (Parameter* n : {&c.mass,         &c.inertia,       &c.load_share,
                       &c.track,        &c.wheel,         &c.wheel_inertia,
                       &c.grip,         &c.rolling,       &c.wall_friction,
                       &m.voltage,      &m.no_load,       &m.no_load_current,
                       &m.stall_torque, &m.stall_current, &m.static_friction,
                       &m.gear,         &m.rotor_inertia, &m.supply,
                       &d.drop,         &d.resistance})
    *n = {n->in(Profile::typical_2).value, 0.0};
  return robot;
}

/// Returns a motor's command for the sketch's value from -255 to 255. The value 0 sets all pins low.
world::WheelCommand command(const robot::Description& robot, const robot::MotorSpec& motor, int told) {
  if (told == 0) return {0.0, 0.0};
  // An Uno's timer 0 has the duty cycle (n + 1) / 256, its other timers n / 255. Uses a value in between.
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

map::Map open_floor() {
  map::Map floor;
  floor.width = floor.height = 40;
  floor.cell_m = kCell;
  floor.cells.assign(1600, map::Cell::floor);
  return floor;
}

const robot::MotorSpec* motor_of(const robot::Description& robot, int side) {
  for (const auto& part : robot.parts)
    if (const auto* motor = dynamic_cast<const robot::MotorSpec*>(part.get()); motor && motor->wheel == side)
      return motor;
  return nullptr;
}

}  // namespace

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

Bench::Bench(const std::vector<Log>& logs, const std::vector<Timed>& timed, const robot::Description& robot,
             double volts)
    : logs_(logs),
      timed_(timed),
      robot_(nominal(robot)),
      body_(robot::body_params(robot_, 1, Profile::typical_2)),
      floor_(open_floor()),
      world_(floor_) {
  if (volts > 0.0) body_.supply_volts = volts;
  for (const int side : {0, 1}) {
    // Uses a start value above 0 if the file gives no friction, because the fit multiplies this value.
    world::WheelParams& wheel = body_.wheel[side];
    wheel.no_load_current = std::max(wheel.no_load_current, 0.03 * wheel.stall_current);
    motors_[side] = motor_of(robot_, side);
  }
}

void Bench::check() {
  double whole = 0.0;
  for (const Log& log : logs_) {
    if (log.drives.empty()) continue;
    const PerTurn counts = per_turn(log);
    for (const Drive& drive : log.drives) {
      spins_ = spins_ || drive.told[0].front() * drive.told[1].front() < 0;
      whole += drive.t.back() - drive.t.front();
      if (whole > kMostDriving)
        throw InputError({log.file, drive.line},
                         fmt::format("the drives are too long: expected at most {:.0f} s together, got "
                                     "{:.0f} s with this drive",
                                     kMostDriving, whole));
      for (const std::size_t side : {0u, 1u}) check(log, drive, side);
      plans_.push_back(plan(drive, counts));
    }
  }
}

std::vector<double> Bench::residuals(const Factors& x, std::vector<DriveCurve>* curves) const {
  return std::move(residuals({&x, 1}, curves).front());
}

std::vector<std::vector<double>> Bench::residuals(std::span<const Factors> all) const {
  return residuals(all, nullptr);
}

std::vector<std::vector<double>> Bench::residuals(std::span<const Factors> all,
                                                  std::vector<DriveCurve>* curves) const {
  const std::vector<Angles> angles = follow(all);
  const std::vector<double> distances = drive_timed(all);
  std::vector<std::vector<double>> residuals(all.size());
  for (std::size_t set = 0; set < all.size(); ++set) {
    for (std::size_t i = 0; i < plans_.size(); ++i)
      compare(plans_[i], angles[set * plans_.size() + i], residuals[set], curves);
    for (std::size_t i = 0; i < timed_.size(); ++i)
      residuals[set].push_back((distances[set * timed_.size() + i] - timed_[i].distance) / timed_[i].sd);
  }
  return residuals;
}

Bench::PerTurn Bench::per_turn(const Log& log) const {
  PerTurn counts{};
  for (const auto& part : robot_.parts) {
    const auto* encoder = dynamic_cast<const robot::EncoderSpec*>(part.get());
    if (!encoder) continue;
    if (!log.counts_per_period)
      throw InputError({log.file},
                       "the log has counts of edges, but not their number in each period of a channel; put "
                       "“# counts_per_period = 2” before its tables (1: rising edges, 2: both)");
    counts[encoder->wheel] = encoder->periods * *log.counts_per_period;
  }
  for (const std::size_t side : {0u, 1u})
    if (counts[side] == 0.0)
      throw InputError({log.file, log.drives.front().line},
                       fmt::format("this drive has counts, but the robot file has no encoder on the {} wheel",
                                   side == 0 ? "left" : "right"));
  return counts;
}

void Bench::check(const Log& log, const Drive& drive, std::size_t side) const {
  const char* name = side == 0 ? "left" : "right";
  const int told = drive.told[side].front();
  double counted = 0.0, along = 0.0;  // sum of counts; sum of counts times command (above 0 if signs agree)
  for (std::size_t i = 1; i < drive.t.size(); ++i) {
    const double more = drive.count[side][i] - drive.count[side][i - 1];
    counted += more;
    along += more * drive.told[side][i - 1];
  }
  const Place place{log.file, drive.line};
  if (told == 0)
    throw InputError({log.file, drive.lines.front()},
                     fmt::format("{}: expected the motor's command in the drive's "
                                 "first row, got 0",
                                 name));
  if (std::fabs(along) < 5.0 * std::abs(told))
    throw InputError(
        place,
        fmt::format("the {} motor is driven with {}, but its encoder counts {:.0f}: the motor does not "
                    "turn, or the encoder does not count",
                    name, told, counted));
  if (along < 0.0)
    throw InputError(place,
                     fmt::format("the {} motor is driven with {}, but its encoder counts {:.0f}: the motor's "
                                 "leads or the encoder's channels are swapped",
                                 name, told, counted));
}

Bench::Plan Bench::plan(const Drive& drive, const PerTurn& per_turn) const {
  Plan plan{&drive, per_turn, {}, {}};
  std::size_t row = 0, sample = 0, tick = 0;
  for (double now = drive.t.front(); sample < drive.t.size(); now += kTick, ++tick) {
    for (; sample < drive.t.size() && drive.t[sample] < now + kTick; ++sample)
      plan.samples.push_back({tick, drive.t[sample] - now});
    Plan::Command mean{tick, {}};
    for (double from = now; from < now + kTick;) {
      const double to = row + 1 < drive.t.size() ? std::min(drive.t[row + 1], now + kTick) : now + kTick;
      for (const int side : {0, 1}) {
        const world::WheelCommand told =
            command(robot_, *motors_[side], drive.told[static_cast<std::size_t>(side)][row]);
        mean.of[side].drive += told.drive * (to - from) / kTick;
        mean.of[side].brake += told.brake * (to - from) / kTick;
      }
      from = to;
      if (row + 1 < drive.t.size() && to >= drive.t[row + 1]) ++row;
    }
    if (plan.commands.empty() || mean.of[0] != plan.commands.back().of[0] ||
        mean.of[1] != plan.commands.back().of[1])
      plan.commands.push_back(mean);
  }
  return plan;
}

// Returns the wheels' angles for each set of factors and each drive.
std::vector<Bench::Angles> Bench::follow(std::span<const Factors> all) const {
  struct Under {
    const Plan* plan;
    std::size_t command = 0, sample = 0;
  };
  batch::Bodies bodies(world_);
  std::vector<Under> ways;
  for (const Factors& x : all)
    for (const Plan& plan : plans_) {
      bodies.add(with(body_, x), kStart);
      ways.push_back({&plan});
    }
  std::vector<Angles> angles(ways.size());
  std::size_t left = ways.size();
  for (std::size_t tick = 0; left > 0; ++tick) {
    for (std::size_t i = 0; i < ways.size(); ++i) {
      auto& [plan, command, sample] = ways[i];
      if (sample == plan->samples.size()) continue;
      for (; sample < plan->samples.size() && plan->samples[sample].tick == tick; ++sample)
        for (const world::Side side : {world::left, world::right})  // rates are constant within a tick
          angles[i][side].push_back(bodies.wheel_angle(i, side) +
                                    bodies.wheel_rate(i, side) * plan->samples[sample].into);
      if (sample == plan->samples.size()) {  // the drive has ended
        bodies.place(i, kStart);
        for (const world::Side side : {world::left, world::right}) bodies.command(i, side, {});
        --left;
      } else if (command < plan->commands.size() && plan->commands[command].tick == tick) {
        for (const world::Side side : {world::left, world::right})
          bodies.command(i, side, plan->commands[command].of[side]);
        ++command;
      }
    }
    if (left > 0) bodies.step();
  }
  return angles;
}

void Bench::compare(const Plan& plan, const Angles& angles, std::vector<double>& all,
                    std::vector<DriveCurve>* curves) const {
  const Drive& drive = *plan.drive;
  const PerTurn& per_turn = plan.per_turn;
  DriveCurve curve{drive.t, {}, {}, {drive.told[0].front(), drive.told[1].front()}};
  for (const std::size_t side : {0u, 1u}) {
    std::vector<double> errors;
    double sum = 0.0;
    for (std::size_t i = 0; i < drive.t.size(); ++i) {
      errors.push_back(drive.count[side][i] - drive.count[side].front() -
                       angles[side][i] / (2.0 * std::numbers::pi) * per_turn[side]);
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
      curve.measured[side].push_back((drive.count[side][i] - drive.count[side].front()) / per_turn[side]);
      curve.fitted[side].push_back(angles[side][i] / (2.0 * std::numbers::pi) + phase / per_turn[side]);
    }
  }
  if (curves) curves->push_back(std::move(curve));
}

// Returns the distance in m for each set of factors and each timed drive.
std::vector<double> Bench::drive_timed(std::span<const Factors> all) const {
  struct Under {
    const Timed* timed;
    int ticks;
    bool is_over = false;
  };
  batch::Bodies bodies(world_);
  std::vector<Under> ways;
  for (const Factors& x : all)
    for (const Timed& timed : timed_) {
      bodies.add(with(body_, x), kStart);
      ways.push_back({&timed, static_cast<int>(std::lround(timed.seconds / kTick))});
    }
  const auto tell = [&](std::size_t body, int told) {
    for (const int side : {0, 1})
      bodies.command(body, static_cast<world::Side>(side), command(robot_, *motors_[side], told));
  };
  std::size_t left = ways.size();
  for (int tick = 0; left > 0; ++tick) {
    for (std::size_t i = 0; i < ways.size(); ++i) {
      if (tick == 0) tell(i, ways[i].timed->told);
      if (tick == ways[i].ticks) tell(i, 0);
    }
    bodies.step();
    for (std::size_t i = 0; i < ways.size(); ++i) {
      const bool stands = tick > ways[i].ticks && bodies.speed(i) == 0.0;
      if (ways[i].is_over || !(stands || tick + 1 == ways[i].ticks + static_cast<int>(kRollsFor / kTick)))
        continue;
      ways[i].is_over = true;
      --left;
    }
  }
  std::vector<double> distances;
  for (std::size_t i = 0; i < ways.size(); ++i) distances.push_back(bodies.distance(i));
  return distances;
}

}  // namespace robosim::calibrate
