#include "sim/detect/lost_pwm.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

namespace robosim::detect {
namespace {

constexpr int kOn = 255, kMostExamined = 200;

std::string pins_with_pwm(const BoardSpec& board) {
  std::string names;
  for (Pin pin = 0; pin < board.pin_count; ++pin)
    if (board.pins[pin].pwm) names += fmt::format("{}{}", names.empty() ? "" : ", ", pin);
  return names;
}

}  // namespace

void LostPwmCalls::add(Pin pin, int value, SimTime t, const std::function<exec::SourceLine()>& where) {
  if (pin >= board_->pin_count || board_->pins[pin].pwm || !board_->pins[pin].digital) return;
  if (value <= 0 || value >= kOn) return;
  const auto known = std::find(pins_.begin(), pins_.end(), pin);
  if (known != pins_.end()) {
    ++found_[static_cast<std::size_t>(known - pins_.begin())].times;
    return;
  }
  pins_.push_back(pin);
  found_.push_back(
      {result::detector("lost_pwm"),
       fmt::format(
           "pin {} of the {} has no PWM, and is LOW below 128 and HIGH otherwise: analogWrite({}, {})", pin,
           board_->name, pin, value),
       fmt::format("Use a pin with PWM: {}.", pins_with_pwm(*board_)), where(), 1e-9 * static_cast<double>(t),
       1});
}

LostPwm::LostPwm(exec::Executor& executor, SnapshotRegistry& snapshots)
    : executor_(executor), state_{{}, LostPwmCalls(executor.board().spec())} {
  RobotPort& board = executor.board();
  state_.asked.resize(board.spec().pin_count);
  for (Pin pin = 0; pin < board.spec().pin_count; ++pin)
    if (!board.spec().pins[pin].pwm) board.watch(pin, *this);
  snapshots.add(state_);
}

void LostPwm::pin_changed(Pin pin, const PinDrive& drive, SimTime t) {
  if (drive.mode != PinMode::output || state_.asked[pin] >= kMostExamined) return;
  ++state_.asked[pin];
  int number = 0, value = 0;
  if (std::sscanf(executor_.call_now().c_str(), "analogWrite(%9d, %9d)", &number, &value) != 2) return;
  if (number == pin) state_.calls.add(pin, value, t, [&] { return executor_.sketch_source(); });
}

}  // namespace robosim::detect
