// read = "rc": a reflectance sensor that is read by timing the discharge of its capacitor.
//
//   pin an output, high   charges: full after 10 us (QTR-8RC: 10 nF through 220 ohm, time constant 2.2 us)
//   pin an output, low    discharges in the same way
//   pin an input          the phototransistor discharges it with a constant current; the pin reads high
//                         until the voltage falls to the input's threshold, half the supply. From a full
//                         charge, this takes T = 1 / (b / black_time + (1 - b) / white_time)
//
// b, the blackness, is sampled once, when the pin becomes an input. The current of the pin's own pull-up is
// negligible compared with the phototransistor's. Times are exact to the nanosecond.
#pragma once

#include "sim/robot/parts/reflectance.h"

namespace robosim::robot {

class RcSensor final : public Sensor, public PinSource, public PinWatcher {
 public:
  RcSensor(const ReflectanceSpec&, const ReflectanceSpec::Element&, const PartContext&, const Emitter&);
  void connect(PartContext&, Pin) override;
  void begin_tick(SimTime) override;
  void pin_changed(Pin, const PinDrive&, SimTime) override;
  Source output(SimTime t, double supply) override { return charge(t) * supply; }
  bool level(SimTime t) override { return t < state_.falls_at; }

 private:
  double charge(SimTime t) const;
  void announce(SimTime from, SimTime to);
  double stuck_blackness() const override;

  struct State {
    // The capacitor's charge, 0..1, at `since`, and its slope from then on, in 1/ns.
    double charge = 0.0;
    double slope = 0.0;
    SimTime since = 0;
    SimTime falls_at = 0;  // time at which the level falls; kNever while the pin charges
    bool driven = false;
    bool announced = true;
  };

  const double white_rate_, black_rate_;  // 1/s, inverse of white_time and black_time
  RobotPort* board_ = nullptr;
  Pin pin_ = kNoPin;
  State state_;
};

}  // namespace robosim::robot
