#include "sim/detect/floating_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace robosim::detect {

FloatingInput::FloatingInput(exec::Executor& executor, SnapshotRegistry& snapshots,
                             const std::vector<robot::WiredPin>& wiring)
    : executor_(executor) {
  for (const robot::WiredPin& wired : wiring) {
    if (!wired.may_float || wired.pin >= executor.board().spec().pin_count) continue;
    state_.contacts.push_back({wired});
    executor.board().watch(wired.pin, *this);
  }
  snapshots.add(state_);
}

void FloatingInput::pin_changed(Pin pin, const PinDrive& drive, SimTime) {
  for (Contact& contact : state_.contacts)
    if (contact.wired.pin == pin && drive.mode == PinMode::output) contact.was_output = true;
}

std::vector<exec::Detected> FloatingInput::found(SimTime) const {
  std::vector<exec::Detected> all;
  for (const Contact& contact : state_.contacts) {
    const Pin pin = contact.wired.pin;
    const exec::PinUse& use = executor_.probe().use(pin);
    const bool is_read = use.looked_at || (use.awaited && !can_capture(executor_.board().spec(), pin));
    if (!is_read || use.pulled_up || contact.was_output) continue;
    const PinSpec& spec = executor_.board().spec().pins[pin];
    const std::string name = spec.name[0] == 'A' ? spec.name : std::to_string(pin);
    all.push_back(
        {result::detector("floating_input"),
         fmt::format("pin {0} ({1}) floats while {1} is not pressed, because nothing gives it a level: "
                     "it is an input without pull-up, and {1} has no resistor in the robot file",
                     name, contact.wired.part),
         fmt::format("Write pinMode({}, INPUT_PULLUP), or state the resistor: resistor = true.", name),
         {},
         1e-9 * static_cast<double>(std::max<SimTime>(use.last_seen, 0)),
         1});
  }
  return all;
}

}  // namespace robosim::detect
