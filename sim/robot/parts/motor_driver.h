// Motor drivers: what the levels of their inputs make of a motor, averaged over a PWM period.
#pragma once

#include "hal/board/board.h"
#include "sim/robot/description.h"
#include "sim/world/body.h"

namespace robosim::robot {

/// The share of time for which a pin is high. The driver's own resistor pulls an undriven pin low.
double high_share(const PinDrive& drive);
/// s, of its PWM; 0 = it has none, or none that is known.
double period_of(const PinDrive& drive);

/// One half of a driver: shares of time for which its inputs are high.
struct BridgeInputs {
  double en = 1.0;
  double in1 = 0.0;
  double in2 = 0.0;
  bool phase = false;     ///< PHASE/ENABLE wiring: in1 is PHASE (high = forward), in2 is its complement
  double period_s = 0.0;  ///< of their PWM; 0 = none, or not known
};

/// The inputs' PWM is taken to be in phase: every input is high from the start of the period for its share of
/// it (so it is for pins of one timer). With f, r, s the shares of forward, reverse, shorted by the chip's
/// table:
///   drive = f - r,  brake = s + 2 min(f, r),  against = min(f, r)
/// because equal forward and reverse shares hold the motor at 0 V, which brakes it.
world::WheelCommand bridge_command(const DriverChip& chip, const BridgeInputs& inputs);

}  // namespace robosim::robot
