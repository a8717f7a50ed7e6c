// The analog comparator. Data sheet DS40002061B, chapter 23.
//
//   +   AIN0, or the bandgap (ACBG)
//   -   AIN1, or the analog input that ADMUX selects (ACME in ADCSRB, while ADEN is 0)
//   ACO = + is higher; ACI is set by its edges that ACIS chooses: 0 any, 2 falling, 3 rising
//
// AIN0 and AIN1 are at the supply or at 0 V, by their level. Voltages are looked at when ACSR is read, and
// every 64 cycles while somebody waits for ACI: an interrupt (ACIE), or the ADC's auto trigger. ACIC (timer
// 1's capture) is not modelled.
#pragma once

#include <cstdint>

#include "sim/avr/pins.h"

namespace robosim::avr {

class Comparator final : public Peripheral {
 public:
  Comparator(Core& core, Pins& pins);

  void reset(Cycle at) override;
  void clock_runs(bool runs, Cycle at) override;
  std::uint64_t may_interrupt() const override;

 private:
  struct State {
    bool output = false;
    bool awaited = false;  ///< the ADC waits for ACI
    bool runs = true;
    Core::Held held;
  };

  std::uint8_t read(Address address);
  void write(Address address, std::uint8_t value);
  void look(Cycle at);
  void look_again(Cycle at);
  void watch_or_not();
  bool awaited(int vector, bool is);
  void entered(int vector);
  void request();
  double negative_volts(Cycle at);
  double volts_at(int pin);

  Core& core_;
  Pins& pins_;
  Address control_;
  int positive_, negative_;  ///< pins
  Events::Id look_ = 0;
  State state_;
};

}  // namespace robosim::avr
