#include "sim/robot/netlist.h"

#include <algorithm>

namespace robosim::robot {

std::string output_name(const std::vector<Register>& registers, Pin output) {
  const int number = output - kMaxPins, q = number % kRegisterOutputs;
  const Register& at = registers[static_cast<std::size_t>(number / kRegisterOutputs)];
  const bool is_channel = at.first_channel >= 0;
  return at.part + (is_channel ? "." : ".Q") + std::to_string(is_channel ? at.first_channel + q : q);
}

std::optional<int> register_of(const std::vector<Register>& registers, const std::string& part) {
  const auto found =
      std::find_if(registers.begin(), registers.end(), [&](const Register& r) { return r.part == part; });
  if (found == registers.end()) return std::nullopt;
  return static_cast<int>(found - registers.begin());
}

void Netlist::watch(Pin pin, PinWatcher& watcher) {
  if (is_output(pin)) {
    watchers_[index_of(pin)].push_back(&watcher);
  } else {
    board_.watch(pin, watcher);
  }
}

void Netlist::drive_output(Pin output, const PinDrive& drive, SimTime t) {
  PinDrive& now = state_.outputs[index_of(output)];
  if (now == drive) return;
  now = drive;
  for (PinWatcher* watcher : watchers_[index_of(output)]) watcher->pin_changed(output, drive, t);
}

}  // namespace robosim::robot
