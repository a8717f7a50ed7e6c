// type = "fan": presses the robot down, as a ducted fan under a skirt does, or a propeller. A transistor on
// its pin lets it run; firmware says how fast by PWM.
//
//   du/dt = (s - u) / spin_up       s: the share of time that its pin is high; u: its speed, of the full one
//   F     = downforce g u^2         half on each wheel, added to [chassis] downforce
//
// u is followed tick by tick, implicitly: u += (s - u) dt / (spin_up + dt). What the tyres then hold and what
// rolling takes is in sim/world/body.h. Source: thrust and suction of a fan grow with the square of its
// speed. Not modelled: what it takes from the battery, and that its motor slows down with it; a controller
// (ESC) that wants servo pulses; leaks where the floor is uneven.
#pragma once

#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_fan(PartReader&);

class FanSpec final : public PartSpec {
 public:
  Pin pin = kNoPin;
  Number downforce;  ///< kg whose weight it presses with at full speed
  Number spin_up;    ///< s

  std::unique_ptr<Part> make(PartContext&) const override;
};

/// Its reading is its speed, of the full one.
class FanPart final : public Part {
 public:
  FanPart(const FanSpec&, PartContext&);

  void join(Roster&) override;
  void begin_tick(SimTime) override;
  void power(bool on, SimTime) override { state_.powered = on; }
  void read(std::vector<Reading>&) const override;
  /// Called once: what it presses down.
  void press_on(world::Body& body) { body_ = &body; }

 private:
  struct State {
    double speed = 0.0;
    double newtons = 0.0;  // with which it presses
    bool powered = true;
  };

  const FanSpec& spec_;
  PartContext& context_;
  const double most_;   // N
  const double share_;  // of the way to its speed in a tick
  world::Body* body_ = nullptr;
  State state_;
};

}  // namespace robosim::robot
