#include "sim/robot/parts/motor_driver.h"

#include <algorithm>

namespace robosim::robot {

double high_share(const PinDrive& drive) {
  switch (drive.mode) {
    case PinMode::input:
      return 0.0;
    case PinMode::input_pullup:
      return 1.0;
    case PinMode::output:
      break;
  }
  if (drive.tone_hz) return 0.5;
  if (drive.pwm) return drive.duty;
  return drive.level ? 1.0 : 0.0;
}

double period_of(const PinDrive& drive) {
  if (drive.mode != PinMode::output) return 0.0;
  if (drive.tone_hz) return 1.0 / drive.tone_hz;
  return drive.pwm && drive.duty > 0.0 && drive.duty < 1.0 ? 1e-6 * drive.period_us : 0.0;
}

world::WheelCommand bridge_command(const DriverChip& chip, const BridgeInputs& inputs) {
  const auto steady = [](double share) { return share == 0.0 || share == 1.0; };
  double share[4] = {0.0, 0.0, 0.0, 0.0};
  const auto add = [&](double time, bool en, bool in1, bool in2) {
    share[static_cast<int>(chip.action[en][in1][inputs.phase ? !in1 : in2])] += time;
  };
  if (steady(inputs.in1) && steady(inputs.in2)) {
    // The enable input alone divides the time.
    add(inputs.en, true, inputs.in1 > 0.0, inputs.in2 > 0.0);
    add(1.0 - inputs.en, false, inputs.in1 > 0.0, inputs.in2 > 0.0);
  } else {
    double ends[4] = {inputs.en, inputs.in1, inputs.in2, 1.0};
    std::sort(ends, ends + 3);
    double begin = 0.0;
    for (const double end : ends) {
      if (end <= begin) continue;
      add(end - begin, begin < inputs.en, begin < inputs.in1, begin < inputs.in2);
      begin = end;
    }
  }
  const double forward = share[static_cast<int>(Bridge::forward)];
  const double reverse = share[static_cast<int>(Bridge::reverse)];
  const double shorted = share[static_cast<int>(Bridge::shorted)];
  const double against = std::min(forward, reverse);
  return {forward - reverse, shorted + 2.0 * against, against, inputs.period_s};
}

}  // namespace robosim::robot
