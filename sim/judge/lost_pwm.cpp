#include "sim/judge/lost_pwm.h"

#include <cstdio>

namespace robosim::judge {
namespace {

constexpr int kMostAsked = 200;

}  // namespace

void LostPwm::pin_changed(Pin pin, const PinDrive& drive, SimTime t, exec::Executor& executor) {
  if (drive.mode != PinMode::output || board_->pins[pin].pwm || asked_[pin] >= kMostAsked) return;
  ++asked_[pin];
  int number = 0, value = 0;
  if (std::sscanf(executor.call_now().c_str(), "analogWrite(%9d, %9d)", &number, &value) != 2) return;
  if (number == pin) calls_.add(pin, value, t, [&] { return executor.sketch_source(); });
}

}  // namespace robosim::judge
