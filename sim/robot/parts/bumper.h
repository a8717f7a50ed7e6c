// type = "bumper": a collision sensor at the robot's front. The sensor is a switch that closes while
// something presses against the body from ahead (world::Body::pressed_ahead). It works like a button, and a
// script can press it, too.
#pragma once

#include "sim/robot/parts/button.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_bumper(PartReader&);

class BumperSpec final : public ButtonSpec {
 public:
  std::unique_ptr<Part> make(PartContext&) const override;
};

class BumperPart final : public ButtonPart {
 public:
  BumperPart(const BumperSpec& spec, PartContext& context) : ButtonPart(spec, context), view_(context.view) {
    context.snapshots.add(state_);
  }

  void register_with(PartRegistry&) override;
  void hold(bool down, SimTime t) override;
  void begin_tick(SimTime) override;
  bool idles() const override { return settled() && !state_.touches; }

 private:
  void follow(bool touches, SimTime t);

  struct State {
    bool held = false, touches = false;
  };

  const View& view_;
  State state_;
};

}  // namespace robosim::robot
