// Computes the effect of a motor driver's inputs on a motor, averaged over a PWM period.
#pragma once

#include <algorithm>

#include "hal/board/board.h"
#include "sim/robot/description.h"
#include "sim/world/body.h"

namespace robosim::robot {

/// Returns the share of time for which a pin is high. The driver's own resistor pulls an undriven pin low.
inline double high_share(const PinDrive& drive) {
  if (drive.mode != PinMode::output) return drive.mode == PinMode::input_pullup ? 1.0 : 0.0;
  if (drive.tone_hz) return 0.5;
  if (drive.pwm) return drive.duty;
  return drive.level ? 1.0 : 0.0;
}
/// Returns the period of a pin's PWM, s; 0 = no PWM, or an unknown period.
double period_of(const PinDrive& drive);

/// The inputs of one half of a driver, as shares of time at high level.
struct BridgeInputs {
  double en = 1.0;
  double in1 = 0.0;
  double in2 = 0.0;
  bool phase = false;     ///< PHASE/ENABLE wiring: in1 is PHASE (high = forward), in2 is its complement
  double period_s = 0.0;  ///< period of the inputs' PWM; 0 = no PWM, or unknown
};

/// Returns the motor command for these inputs. Assumes that the inputs' PWM is in phase, as for pins of one
/// timer: each input is high from the start of the period. Let f, r and s be the shares of time for which the
/// chip's table says forward, reverse and shorted:
///   drive = f - r,  brake = s + 2 min(f, r),  against = min(f, r)
/// Equal forward and reverse shares hold the motor at 0 V, which brakes it.
inline world::WheelCommand bridge_command(const DriverChip& chip, const BridgeInputs& inputs);

/// Adds up, for each action of the chip, the share of time for which the chip performs it.
class BridgeShares {
 public:
  BridgeShares(const DriverChip& chip, bool phase) : chip_(chip), phase_(phase) {}
  void add(double time, bool en, bool in1, bool in2) {
    share_[static_cast<int>(chip_.action[en][in1][phase_ ? !in1 : in2])] += time;
  }
  world::WheelCommand command(double period_s) const {
    const double forward = share_[static_cast<int>(Bridge::forward)];
    const double reverse = share_[static_cast<int>(Bridge::reverse)];
    const double shorted = share_[static_cast<int>(Bridge::shorted)];
    const double against = std::min(forward, reverse);
    return {forward - reverse, shorted + 2.0 * against, against, period_s};
  }

 private:
  const DriverChip& chip_;
  const bool phase_;
  double share_[4] = {0.0, 0.0, 0.0, 0.0};
};

/// Computes bridge_command() for the case that in1 or in2 has PWM.
world::WheelCommand divided_command(const DriverChip& chip, BridgeInputs inputs);

inline world::WheelCommand bridge_command(const DriverChip& chip, const BridgeInputs& inputs) {
  const auto changes = [](double share) { return share > 0.0 && share < 1.0; };
  if (changes(inputs.in1) || changes(inputs.in2)) [[unlikely]]
    return divided_command(chip, inputs);
  BridgeShares shares(chip, inputs.phase);
  shares.add(inputs.en, true, inputs.in1 > 0.0, inputs.in2 > 0.0);
  shares.add(1.0 - inputs.en, false, inputs.in1 > 0.0, inputs.in2 > 0.0);
  return shares.command(inputs.period_s);
}

}  // namespace robosim::robot
