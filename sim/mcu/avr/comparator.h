// Models the analog comparator (data sheet DS40002061B, chapter 23).
//
//   +      AIN0, or the bandgap (ACBG)
//   -      AIN1, or the analog input that ADMUX selects (ACME in ADCSRB, while ADEN is 0). A chip without
//          AIN1 uses the bandgap (ATmega32U4, 7766J, 23.2)
//   ACO    1 if + is higher
//   ACI    set by the edges of ACO that ACIS selects: 0 any, 2 falling, 3 rising
//   ACIC   timer 1 captures edges of ACO instead of edges of ICP1
//
// After the first write to ACSR, an edge of AIN0 or AIN1 takes effect in the cycle of the edge. Other voltage
// changes are sampled when ACSR is read or written. They are also sampled every 64 cycles while an interrupt
// (ACIE), timer 1 (ACIC) or the ADC's auto trigger waits for an edge.
//
// Not modelled: the synchroniser delay of ACO (1 to 2 cycles), and the comparator's offset and hysteresis. On
// a board, a pin with PWM has the supply voltage if its duty cycle is at least 50 %, otherwise 0 V.
#pragma once

#include <array>
#include <cstdint>

#include "sim/mcu/avr/pins.h"

namespace robosim::avr {

class Timer;

class Comparator final : public Peripheral {
 public:
  /// `captures` is the timer that captures the comparator's edges, or null.
  Comparator(Core& core, Pins& pins, Timer* captures);

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
  void write_bit(Address address, std::uint8_t value, std::uint8_t bit);
  void look(Cycle at);
  void look_again(Cycle at);
  void heard(int pin, bool level, Cycle at);
  void watch_or_not();
  bool awaited(int vector, bool is);
  void entered(int vector);
  void request();
  bool is_on() const;
  double negative_volts(Cycle at);

  Core& core_;
  Pins& pins_;
  Timer* const captures_;
  Address control_;
  int positive_, negative_;  ///< input pins; -1 = none
  std::array<int, 2> listeners_{-1, -1};
  Events::Id look_ = 0;
  State state_;
};

}  // namespace robosim::avr
