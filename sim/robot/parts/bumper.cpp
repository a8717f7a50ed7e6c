#include "sim/robot/parts/bumper.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_bumper(PartReader& reader) {
  return read_button_keys(reader, std::make_shared<BumperSpec>());
}

std::unique_ptr<Part> BumperSpec::make(PartContext& context) const {
  return std::make_unique<BumperPart>(*this, context);
}

void BumperPart::register_with(PartRegistry& registry) {
  ButtonPart::register_with(registry);
  registry.ticking.push_back(this);
}

void BumperPart::hold(bool down, SimTime t) {
  state_.held = down;
  ButtonPart::hold(state_.held || state_.touches, t);
}

void BumperPart::begin_tick(SimTime t) {
  const bool touches = view_.body->pressed_ahead();
  if (touches != state_.touches || !settled()) follow(touches, t);
}

[[gnu::noinline]] void BumperPart::follow(bool touches, SimTime t) {
  state_.touches = touches;
  hold(state_.held, t);
  ButtonPart::begin_tick(t);
}

}  // namespace robosim::robot
