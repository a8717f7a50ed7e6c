#include "sim/robot/netlist.h"

namespace robosim::robot {

std::string output_name(const std::vector<std::string>& registers, Pin output) {
  const int number = output - kMaxPins;
  return registers[static_cast<std::size_t>(number / kRegisterOutputs)] + ".Q" +
         std::to_string(number % kRegisterOutputs);
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
