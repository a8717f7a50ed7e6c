// The analog to digital converter (datasheet, chapter 24). hal/board/avr_adc.h has the meaning of its
// registers.
#pragma once

#include <stdint.h>

#include "hal/board/avr_adc.h"
#include "hal/board/sim_time.h"
#include "hal/host/clock.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

class Adc {
 public:
  uint8_t multiplexer() const { return multiplexer_; }
  void set_multiplexer(uint8_t value);
  uint8_t control() const;
  void set_control(uint8_t value);
  uint8_t control_b() const { return control_b_; }
  void set_control_b(uint8_t value);
  /// The result as the register ADC holds it: left-adjusted if ADLAR says so.
  uint16_t data() const;

  /// Samples the selected channel, `late` after now: for analogRead, which does its own waiting, 0.
  uint16_t sample(SimTime late);
  /// The converter's capacitor is led to what is selected from now on: another channel, or the same after a
  /// conversion.
  void charge() { charges_since_ = state.now; }
  /// The code of a voltage at the selected reference.
  uint16_t code_of(double volts) const;
  /// One ADC clock.
  SimTime clock() const { return cycles(avr::adc_prescaler(control_)); }
  /// When a conversion begins that is asked for now: with the next ADC clock.
  SimTime next_start() const { return next_start(clock()); }
  SimTime next_start(SimTime clock) const {
    const SimTime past = state.now - clock_began_;
    return clock_began_ + (past + clock - 1) / clock * clock;
  }
  bool on() const { return control_ & 0x80; }
  /// A conversion begins: whether it is the first one behind ADEN, which takes longer (24.4). For an
  /// analogRead() init()'s ADEN does not count: it takes as long as any other, which the traces of all
  /// sketches stand on.
  bool take_first(bool of_analog_read) {
    const bool first = of_analog_read ? first_ == First::by_sketch : first_ != First::over;
    first_ = First::over;
    return first;
  }
  void enabled_by_init() { first_ = First::by_init; }
  /// A conversion has ended with this code: what reading ADCL and then ADCH gives.
  uint16_t end_with(uint16_t code) {
    if (!locked_) code_ = code;
    locked_ = false;
    return code_;
  }
  /// ADCL has been read: ADCL and ADCH stay as they are until ADCH is read (24.9.3).
  void lock() { locked_ = true; }
  void unlock() { locked_ = false; }

  /// Ends the conversion that is due; restarts it when free running.
  void sync() {
    if (converting_) sync_conversion();
  }
  bool converts() const { return converting_; }
  bool pending() const { return (control_ & 0x18) == 0x18; }
  bool may_interrupt() const { return control_ & 0x08 && (converting_ || control_ & 0x20); }
  SimTime next() const { return converting_ && control_ & 0x08 ? ready_ : kNever; }
  void acknowledge() { control_ &= ~0x10; }

 private:
  void start();
  ROBOSIM_RARE void sync_conversion();
  void look_for_trigger() const;

  uint8_t multiplexer_ = 0, control_ = 0, control_b_ = 0;
  bool converting_ = false, locked_ = false;
  enum class First : uint8_t { over, by_init, by_sketch } first_ = First::over;  ///< whose ADEN it follows
  uint16_t code_ = 0, result_ = 0;
  SimTime ready_ = 0;
  double held_ = 0.0;          ///< V, on its capacitor
  SimTime charges_since_ = 0;  ///< from what is selected
  SimTime clock_began_ = 0;    ///< the ADC clock runs from when the ADC was enabled
};

extern Adc adc;

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
