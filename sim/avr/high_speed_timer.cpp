#include "sim/avr/high_speed_timer.h"

#include <algorithm>

namespace robosim::avr {
namespace {

// Registers, from TCCR4A on.
constexpr int kHigh = -1, kTccr4a = 0, kTccr4b = 1, kTccr4c = 2, kTccr4d = 3;
constexpr std::size_t kA = 0, kB = 1, kTop = 2, kD = 3;
constexpr std::uint8_t kClockMask = 0x0F, kModeMask = 0x03, kFast = 0, kHighMask = 0x03;
constexpr std::uint8_t kPwmA = 0x02, kPwmB = 0x01, kPwmD = 0x01, kConnections = 0xF0, kShadows = 0xF0;
constexpr std::uint16_t kTopAtReset = 0xFF;

}  // namespace

HighSpeedTimer::HighSpeedTimer(Core& core, Pins& pins, int index)
    : core_(core), pins_(pins), spec_(core.chip.timers[index]) {
  output_pins_.fill(-1);
  for (int pin = 0; pin < core.chip.pin_count; ++pin)
    if (core.chip.pins[pin].timer == index) output_pins_[core.chip.pins[pin].output] = pin;
  for (int offset = kTccr4a; offset <= kTccr4d; ++offset)
    core.cpu.on_write<&HighSpeedTimer::write>(
        static_cast<Address>(spec_.control + static_cast<unsigned>(offset)), this);
  for (unsigned output = 0; output < kOutputs; ++output)
    core.cpu.on_write<&HighSpeedTimer::write_compare>(static_cast<Address>(spec_.compare[0] + output), this);
  core.keep(state_);
}

void HighSpeedTimer::reset(Cycle) {
  state_ = {};
  state_.compare[kTop] = kTopAtReset;
  core_.at(static_cast<Address>(spec_.compare[0] + kTop)) = kTopAtReset;
}

void HighSpeedTimer::clock_runs(bool runs, Cycle) {
  state_.runs = runs;
  tell_drives();
}

// The bits COM4A and COM4B are in TCCR4C again.
void HighSpeedTimer::write(Address address, std::uint8_t value) {
  if (!state_.runs) return;
  core_.at(address) = value;
  const auto a = static_cast<Address>(spec_.control), c = static_cast<Address>(a + kTccr4c);
  const auto with = [](std::uint8_t to, std::uint8_t from) {
    return static_cast<std::uint8_t>((to & ~kConnections) | (from & kShadows));
  };
  if (address == a) core_.at(c) = with(core_.at(c), value);
  if (address == c) core_.at(a) = with(core_.at(a), value);
  tell_drives();
}

void HighSpeedTimer::write_compare(Address address, std::uint8_t value) {
  if (!state_.runs) return;
  core_.at(address) = value;
  state_.compare[address - spec_.compare[0]] =
      static_cast<std::uint16_t>((control(kHigh) & kHighMask) << 8 | value);
  tell_drives();
}

int HighSpeedTimer::connection(std::size_t output) const {
  switch (output) {
    case kA:
      return control(kTccr4a) >> 6 & 3;
    case kB:
      return control(kTccr4a) >> 4 & 3;
    case kD:
      return control(kTccr4c) >> 2 & 3;
    default:
      return 0;
  }
}

bool HighSpeedTimer::has_pwm(std::size_t output) const {
  return output == kA   ? control(kTccr4a) & kPwmA
         : output == kB ? control(kTccr4a) & kPwmB
                        : control(kTccr4c) & kPwmD;
}

void HighSpeedTimer::tell_drives() {
  const bool fast = (control(kTccr4d) & kModeMask) == kFast;
  const int top = std::max<int>(state_.compare[kTop], 1);
  const bool clocked = state_.runs && control(kTccr4b) & kClockMask;
  for (std::size_t output = 0; output < kOutputs; ++output) {
    const int pin = output_pins_[output], com = connection(output);
    if (pin < 0) continue;
    if (com == 0 || !clocked || !has_pwm(output)) {
      if (state_.taken[output]) pins_.give_back(pin);
      state_.taken[output] = false;
      continue;
    }
    const int value = std::min<int>(state_.compare[output], top);
    const double high = fast ? (value + 1.0) / (top + 1.0) : static_cast<double>(value) / top;
    PinDrive drive;
    drive.mode = PinMode::output;
    drive.pwm = true;
    drive.duty = com == 3 ? 1.0 - high : high;
    pins_.take(pin, drive);
    state_.taken[output] = true;
  }
}

}  // namespace robosim::avr
