// A robot's body that is driven as a log says, with figures that may be changed: what it makes of a drive,
// against what was counted. The figures, and what can be told from them, are at the top of drive_fit.h.
#pragma once

#include <array>
#include <vector>

#include "sim/calibrate/drive_fit.h"
#include "sim/robot/parts/motor.h"
#include "sim/world/world.h"

namespace robosim::calibrate {

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

class Bench {
 public:
  /// `volts`: of the battery; 0 = as the file has it. The robot is taken without spreads, as typical@2 has
  /// it.
  Bench(const std::vector<Log>& logs, const std::vector<Timed>& timed, const robot::Description& robot,
        double volts);

  /// The body with all factors 1.
  const world::BodyParams& body() const { return body_; }
  bool has_motors() const { return motors_[0] && motors_[1]; }
  /// Throws InputError for drives that no figures make.
  void check();
  /// Whether a drive turns on the spot.
  bool spins() const { return spins_; }
  /// What was counted less what these factors make, in counts; of timed drives over what they are uncertain
  /// by. Of a longer drive each half second is looked at by itself: errors of its place grow.
  std::vector<double> residuals(const Factors& x, std::vector<DriveCurve>* curves = nullptr) const;

 private:
  using PerTurn = std::array<double, 2>;  ///< counts of each wheel

  PerTurn per_turn(const Log&) const;
  void check(const Log&, const Drive&, std::size_t side) const;
  std::array<std::vector<double>, 2> follow(world::World&, const Drive&) const;
  void compare(const Drive&, const std::array<std::vector<double>, 2>& angles, const PerTurn&,
               std::vector<double>& all, std::vector<DriveCurve>* curves) const;
  double drive_timed(world::World&, const Timed&) const;

  const std::vector<Log>& logs_;
  const std::vector<Timed>& timed_;
  const robot::Description robot_;
  world::BodyParams body_;
  const robot::MotorSpec* motors_[2] = {};
  bool spins_ = false;
  grid::Map floor_;
};

/// The body with its figures times these factors.
world::BodyParams with(world::BodyParams body, const Factors& x);

}  // namespace robosim::calibrate
