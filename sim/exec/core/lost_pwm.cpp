#include "sim/exec/core/lost_pwm.h"

#include <fmt/format.h>

#include <algorithm>

namespace robosim::exec {
namespace {

constexpr int kOn = 255;

std::string pins_with_pwm(const BoardSpec& board) {
  std::string names;
  for (Pin pin = 0; pin < board.pin_count; ++pin)
    if (board.pins[pin].pwm) names += fmt::format("{}{}", names.empty() ? "" : ", ", pin);
  return names;
}

}  // namespace

void LostPwmCalls::add(Pin pin, int value, SimTime t, const std::function<SourceLine()>& where) {
  if (pin >= board_->pin_count || board_->pins[pin].pwm || !board_->pins[pin].digital) return;
  if (value <= 0 || value >= kOn) return;
  const auto known = std::find(pins_.begin(), pins_.end(), pin);
  if (known != pins_.end()) {
    ++found_[static_cast<std::size_t>(known - pins_.begin())].times;
    return;
  }
  pins_.push_back(pin);
  found_.push_back(
      {"lost_pwm",
       fmt::format(
           "pin {} of the {} has no PWM, and is LOW below 128 and HIGH otherwise: analogWrite({}, {})", pin,
           board_->name, pin, value),
       fmt::format("Use a pin with PWM: {}.", pins_with_pwm(*board_)), where(), 1e-9 * static_cast<double>(t),
       1});
}

}  // namespace robosim::exec
