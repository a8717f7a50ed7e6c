#include "sim/detect/driven_input.h"

#include <fmt/format.h>

#include <algorithm>

namespace robosim::detect {
namespace {

constexpr SimTime kLong = 100 * kMillisecond;

bool gives_a_level(const robot::WiredPin& wired) {
  return wired.type == "button" || wired.type == "bumper" || wired.type == "encoder" ||
         wired.type == "ir-receiver" || wired.type == "ir-switch" || wired.role == "txd" ||
         wired.role == "echo" || (wired.type == "reflectance-array" && !wired.role.starts_with("emitter"));
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
  std::vector<const Input*> driven;
  for (const Input& input : state_.inputs)
    if (input.output_since && (input.is_found || now - *input.output_since >= kLong))
      driven.push_back(&input);
  if (driven.empty()) return {};
  std::string pins;
  for (const Input* const one : driven)
    pins += fmt::format("{}{} ({})",
                        pins.empty()           ? ""
                        : one == driven.back() ? " and "
                                               : ", ",
                        one->wired.pin,
                        one->wired.type == "reflectance-array" ? one->wired.role : one->wired.part);
  const Input& first = **std::min_element(
      driven.begin(), driven.end(),
      [](const Input* one, const Input* other) { return *one->output_since < *other->output_since; });
  const bool several = driven.size() > 1;
  return {{result::detector("driven_input"),
           fmt::format(
               "pin{} {} {}, but the part on it outputs a level, too, and the two drive against each other; "
               "it was set",
               several ? "s" : "", pins, several ? "are outputs" : "is an output"),
           "Set the pin to INPUT. If the part is at another pin, correct the robot file (“robosim wire” "
           "drafts one).",
           first.where, 1e-9 * static_cast<double>(*first.output_since),
           static_cast<std::int64_t>(driven.size())}};
}

}  // namespace robosim::detect
