// Repeats a log's motor commands with a simulated body of variable parameters. Compares the angles of the
// body's wheels with the log's encoder counts. The top of drive_fit.h lists the parameters, and the
// measurements that determine them. The motors' commands in each tick are computed once. All drives, for any
// number of parameter sets, are then simulated in parallel, as bodies of one batch
// (sim/world/batch/bodies.h).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/campaign/calibrate/drive_fit.h"
#include "sim/robot/parts/motor.h"
#include "sim/world/batch/bodies.h"
#include "sim/world/world.h"

namespace robosim::calibrate {

/// The fitted and fixed values. Each is the logarithm of a factor that multiplies a parameter of the robot
/// file.
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

class Bench {
 public:
  /// `volts` is the battery's voltage; 0 = as in the file. The robot's parameters are
  /// the nominal values of the profile typical@2.
  Bench(const std::vector<Log>& logs, const std::vector<Timed>& timed, const robot::Description& robot,
        double volts);

  /// Returns the body for factors of 1.
  const world::BodyParams& body() const { return body_; }
  bool has_motors() const { return motors_[0] && motors_[1]; }
  /// Throws InputError for drives that no parameters can produce.
  void check();
  /// Returns whether any drive turns on the spot.
  bool spins() const { return spins_; }
  /// Returns the differences between measurement and simulation with these factors. A difference is in counts
  /// of an encoder. For a drive timed with a stopwatch, it is in multiples of the measurement's uncertainty.
  /// Each half second of a longer drive is compared separately, because position errors grow.
  std::vector<double> residuals(const Factors& x, std::vector<DriveCurve>* curves = nullptr) const;
  /// Returns the residuals for each set of factors.
  std::vector<std::vector<double>> residuals(std::span<const Factors> all) const;

 private:
  using PerTurn = std::array<double, 2>;              ///< counts per turn of each wheel
  using Angles = std::array<std::vector<double>, 2>;  ///< rad, of each wheel, at the samples of a drive
  /// The commands and samples of a drive, by tick.
  struct Plan {
    const Drive* drive;
    PerTurn per_turn;
    struct Command {
      std::size_t tick;
      world::WheelCommand of[2];
    };
    std::vector<Command> commands;  ///< one for each change
    struct Sample {
      std::size_t tick;
      double into;  ///< s since the beginning of the tick
    };
    std::vector<Sample> samples;
  };

  PerTurn per_turn(const Log&) const;
  void check(const Log&, const Drive&, std::size_t side) const;
  Plan plan(const Drive&, const PerTurn&) const;
  std::vector<Angles> follow(std::span<const Factors>) const;
  std::vector<double> drive_timed(std::span<const Factors>) const;
  void compare(const Plan&, const Angles&, std::vector<double>& all, std::vector<DriveCurve>* curves) const;
  std::vector<std::vector<double>> residuals(std::span<const Factors>, std::vector<DriveCurve>*) const;

  const std::vector<Log>& logs_;
  const std::vector<Timed>& timed_;
  const robot::Description robot_;
  world::BodyParams body_;
  const robot::MotorSpec* motors_[2] = {};
  bool spins_ = false;
  const map::Map floor_;
  const world::World world_;
  std::vector<Plan> plans_;  ///< set by check()
};

/// Returns the body with each parameter multiplied by its factor, exp(x).
world::BodyParams with(world::BodyParams body, const Factors& x);

}  // namespace robosim::calibrate
