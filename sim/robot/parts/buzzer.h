// type = "buzzer": a buzzer, whose sound affects nothing else. An active buzzer sounds while its pin is high.
// A passive buzzer follows its pin. Its pitch is the frequency of `tone()`, or is computed from the pin's
// last two rising edges. The buzzer falls silent 50 ms after the last rising edge. PWM by a timer counts as
// 490 Hz, whatever the timer's frequency.
#pragma once

#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_buzzer(PartReader&);

class BuzzerSpec final : public PartSpec {
 public:
  Pin pin = kNoPin;
  bool passive = true;

  std::unique_ptr<Part> make(PartContext&) const override;
  std::vector<Gauge> gauges() const override {
    return passive ? std::vector<Gauge>{{name, "Hz"}} : std::vector<Gauge>{};
  }
};

class BuzzerPart final : public Part, public PinWatcher {
 public:
  BuzzerPart(const BuzzerSpec&, PartContext&);

  void register_with(PartRegistry&) override;
  void pin_changed(Pin, const PinDrive&, SimTime) override;
  /// Appends a passive buzzer's frequency in Hz, or the share of time for which an active buzzer sounds.
  void read(std::vector<Reading>&) const override;

 private:
  double pitch(SimTime t) const;

  struct State {
    bool high = false;
    SimTime rose = 0, rose_before = 0;
  };

  const BuzzerSpec& spec_;
  PartContext& context_;
  State state_;
};

}  // namespace robosim::robot
