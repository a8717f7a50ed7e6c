#include "sim/robot/parts/motor_driver.h"

#include <algorithm>

namespace robosim::robot {

double period_of(const PinDrive& drive) {
  if (drive.mode != PinMode::output) return 0.0;
  if (drive.tone_hz) return 1.0 / drive.tone_hz;
  return drive.pwm && drive.duty > 0.0 && drive.duty < 1.0 ? 1e-6 * drive.period_us : 0.0;
}

world::WheelCommand divided_command(const DriverChip& chip, BridgeInputs inputs) {
  BridgeShares shares(chip, inputs.phase);
  double ends[4] = {inputs.en, inputs.in1, inputs.in2, 1.0};
  std::sort(ends, ends + 3);
  double begin = 0.0;
  for (const double end : ends) {
    if (end <= begin) continue;
    shares.add(end - begin, begin < inputs.en, begin < inputs.in1, begin < inputs.in2);
    begin = end;
  }
  return shares.command(inputs.period_s);
}

}  // namespace robosim::robot
