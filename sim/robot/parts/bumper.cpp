#include "sim/robot/parts/bumper.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_bumper(PartReader& reader) {
  return read_button_keys(reader, std::make_shared<BumperSpec>());
}

std::unique_ptr<Part> BumperSpec::make(PartContext& context) const {
  return std::make_unique<BumperPart>(*this, context);
}

void BumperPart::join(Roster& roster) {
  ButtonPart::join(roster);
  roster.ticking.push_back(this);
}

void BumperPart::hold(bool down, SimTime t) {
  held_ = down;
  ButtonPart::hold(held_ || touches_, t);
}

void BumperPart::begin_tick(SimTime t) {
  const bool touches = view_.body->pressed_ahead();
  if (touches == touches_ && settled()) return;
  touches_ = touches;
  hold(held_, t);
  ButtonPart::begin_tick(t);
}

}  // namespace robosim::robot
