#include "sim/detect/driven_input.h"

#include <fmt/format.h>

namespace robosim::detect {
namespace {

constexpr SimTime kLong = 100 * kMillisecond;

bool gives_a_level(const robot::WiredPin& wired) {
  return wired.type == "button" || wired.type == "bumper" || wired.type == "encoder" ||
         wired.type == "ir-receiver" ||
         (wired.type == "reflectance-array" && !wired.role.starts_with("emitter"));
}

}  // namespace

DrivenInput::DrivenInput(exec::Executor& executor, SnapshotRegistry& snapshots,
                         const std::vector<robot::WiredPin>& wiring)
    : executor_(executor) {
  for (const robot::WiredPin& wired : wiring) {
    if (wired.pin >= executor.board().spec().pin_count || !gives_a_level(wired)) continue;
    state_.inputs.push_back({wired, std::nullopt, {}});
    executor.board().watch(wired.pin, *this);
  }
  snapshots.add(state_);
}

void DrivenInput::pin_changed(Pin pin, const PinDrive& drive, SimTime t) {
  for (Input& input : state_.inputs) {
    if (input.wired.pin != pin || input.is_found) continue;
    const bool is_output = drive.mode == PinMode::output;
    if (is_output == input.output_since.has_value()) continue;
    if (is_output) {
      input.output_since = t;
      if (input.where.file.empty()) input.where = executor_.sketch_source();
    } else {
      input.is_found = t - *input.output_since >= kLong;
      if (!input.is_found) input.output_since.reset();
    }
  }
}

void DrivenInput::powered_on() {
  for (Input& input : state_.inputs)
    if (!input.is_found) input.output_since.reset();
}

std::vector<exec::Detected> DrivenInput::found(SimTime now) const {
  std::vector<exec::Detected> all;
  for (const Input& input : state_.inputs) {
    if (!input.output_since || (!input.is_found && now - *input.output_since < kLong)) continue;
    const robot::WiredPin& wired = input.wired;
    all.push_back(
        {result::detector("driven_input"),
         fmt::format("pin {} is an output, but the sketch should read a part there ({}, {}): the two drive "
                     "against each other; it was set",
                     wired.pin, wired.role.empty() ? wired.part : wired.role, wired.type),
         fmt::format("Call pinMode({}, INPUT), or wire the part to another pin.", wired.pin), input.where,
         1e-9 * static_cast<double>(*input.output_since), 1});
  }
  return all;
}

}  // namespace robosim::detect
