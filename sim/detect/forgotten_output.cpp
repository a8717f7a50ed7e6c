#include "sim/detect/forgotten_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace robosim::detect {
namespace {

constexpr SimTime kSoon = 100 * kMillisecond;
constexpr Pin kAmplified = 13;

bool is_driven(const std::string& type) {
  constexpr std::array<std::string_view, 10> kTypes = {
      "motor", "motors",  "wheel-servo",    "led",          "buzzer", "servo",
      "fan",   "stepper", "shift-register", "seven-segment"};
  return std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
}

}  // namespace

ForgottenOutput::ForgottenOutput(exec::Executor& executor, SnapshotRegistry& snapshots,
                                 const std::vector<robot::WiredPin>& wiring)
    : executor_(executor) {
  const int pins = executor.board().spec().pin_count;
  for (const robot::WiredPin& wired : wiring) {
    if (wired.pin >= pins || !is_driven(wired.type)) continue;
    state_.pins.push_back({wired});
    executor.board().watch(wired.pin, *this);
  }
  snapshots.add(state_);
}

void ForgottenOutput::pin_changed(Pin pin, const PinDrive& drive, SimTime t) {
  for (Driven& one : state_.pins) {
    if (one.wired.pin != pin) continue;
    if (drive.mode == PinMode::output) one.was_output = true;
    if (drive.mode != PinMode::input_pullup || one.was_output || one.pulled_up) continue;
    one.pulled_up = t;
    one.where = executor_.sketch_source();
  }
}

std::vector<exec::Detected> ForgottenOutput::found(SimTime now) const {
  std::vector<exec::Detected> all;
  for (const Driven& one : state_.pins)
    if (one.pulled_up && !one.was_output && now - *one.pulled_up >= kSoon)
      all.push_back(
          {result::detector("forgotten_output"),
           fmt::format(
               "pin {} ({}) was never set to OUTPUT: HIGH only turns on its pull-up of 20 to 50 kOhm, a "
               "tenth of a milliampere{}; it was written",
               one.wired.pin, one.wired.part,
               one.wired.type == "led" && one.wired.pin == kAmplified
                   ? " (an Uno R3 has an amplifier before its own LED; a Nano and many clones have none)"
                   : ""),
           fmt::format("Set it to OUTPUT in setup(): pinMode({}, OUTPUT), or its bit in DDRx.",
                       one.wired.pin),
           one.where, 1e-9 * static_cast<double>(*one.pulled_up), 1});
  return all;
}

}  // namespace robosim::detect
