// Models the analog-to-digital converter (data sheet DS40002061B, chapter 24). hal/board/avr_adc.h documents
// the converter's registers. One period of the ADC clock takes P processor cycles; ADPS selects P. The
// prescaler starts when ADEN is set. The rising edges of the ADC clock occur at these cycles e:
//
//   e = origin + P/2 + k P            origin: the cycle at which ADEN was set; k = 0, 1, 2 …
//   start    the first e after ADSC is written; ADMUX is latched at this edge
//   sample   start + 1.5 P; 13.5 P in the first conversion after ADEN
//   end      start + 13 P; 25 P in the first conversion. ADIF is set, and ADSC reads 0. In free running
//            mode, the next conversion starts
//
// An auto trigger restarts the prescaler: origin becomes the third cycle after the trigger's flag is set. The
// sample is then taken at origin + 2 P, and the conversion ends at origin + 13.5 P (table 24-1). The chip
// also starts a conversion when it enters a sleep mode in which the ADC clock runs (10.3, 24.6). While auto
// triggering is enabled, entering sleep does not start a conversion. A stopped clock (PRR, deeper sleep)
// pauses a conversion; clearing ADEN ends the conversion.
#pragma once

#include <cstdint>

#include "hal/board/adc_capacitor.h"
#include "sim/mcu/avr/core.h"
#include "sim/mcu/avr/pins.h"

namespace robosim::avr {

class Adc final : public Peripheral {
 public:
  Adc(Core& core, Pins& pins);

  void reset(Cycle at) override;
  void clock_runs(bool runs, Cycle at) override;
  void falls_asleep(bool adc_clock_runs, Cycle at) override;
  std::uint64_t may_interrupt() const override;

 private:
  struct State {
    Cycle origin = 0;  ///< cycle at which the prescaler started
    Cycle start = 0;   ///< cycle at which the conversion starts
    Core::Held held_sample, held_end;
    std::uint16_t sampled = 0, result = 0;
    std::uint8_t multiplexer = 0, control_b = 0;  ///< ADMUX and ADCSRB, latched by the conversion
    AdcCapacitor capacitor;
    Cycle charges_since = 0;  ///< cycle from which the selected input charges the capacitor
    bool runs = true;
    bool first = false;  ///< no conversion has begun since ADEN was set
    bool converting = false;
    bool locked = false;  ///< ADCL was read, and ADCH has not been read since then
  };

  std::uint8_t read_control(Address address);
  std::uint8_t read_data(Address address);
  std::uint8_t read_plain(Address address);
  void write_control(Address address, std::uint8_t value);
  void write_control_bit(Address address, std::uint8_t value, std::uint8_t bit);
  void write_control_b(Address address, std::uint8_t value);
  void write_multiplexer(Address address, std::uint8_t value);
  void select();
  void selects_another(std::uint8_t multiplexer, std::uint8_t control_b);
  void triggered(Cycle at);
  void start(Cycle edge);
  void sample(Cycle at);
  void end(Cycle at);
  void abort();
  void entered(int vector);
  void request();
  int trigger() const;
  Cycle clock() const;
  Cycle edge_after(Cycle cycle) const;

  Core& core_;
  const AvrRegisters& at_;
  Pins& pins_;
  Events::Id sample_ = 0, end_ = 0;
  State state_;
};

}  // namespace robosim::avr
