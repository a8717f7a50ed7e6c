// type = "fan": a fan that presses the robot down: a ducted fan under a skirt, or a propeller. A transistor
// on its pin switches the fan; firmware sets the speed by PWM.
//
//   du/dt = (s - u) / spin_up       s: duty cycle of the pin; u: speed relative to full speed
//   F     = downforce g u^2         half on each wheel, added to [chassis] downforce
//
// u is integrated tick by tick, implicitly: u += (s - u) dt / (spin_up + dt). sim/world/body.h describes the
// effect on grip and rolling resistance. The thrust and suction of a fan grow with the square of its speed.
//
// Not modelled: the fan's current from the battery; a controller (ESC) that needs servo pulses; leaks on an
// uneven floor.
#pragma once

#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_fan(PartReader&);

class FanSpec final : public PartSpec {
 public:
  Pin pin = kNoPin;
  Parameter downforce;  ///< kg, mass whose weight equals the downforce at full speed
  Parameter spin_up;    ///< s

  std::unique_ptr<Part> make(PartContext&) const override;
};

/// A fan, whose reading is its speed relative to full speed.
class FanPart final : public Part {
 public:
  FanPart(const FanSpec&, PartContext&);

  void register_with(PartRegistry&) override;
  void begin_tick(SimTime) override;
  void power(bool on, SimTime) override { state_.powered = on; }
  void read(std::vector<Reading>&) const override;
  /// Sets the body that the fan presses down. The robot calls this function once.
  void press_on(world::Body& body) { body_ = &body; }

 private:
  struct State {
    double speed = 0.0;
    double newtons = 0.0;  // the current downforce
    bool powered = true;
  };

  const FanSpec& spec_;
  PartContext& context_;
  const double most_;   // N
  const double share_;  // one tick removes this fraction of the difference from the target speed
  world::Body* body_ = nullptr;
  State state_;
};

}  // namespace robosim::robot
