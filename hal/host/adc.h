// Models the analog-to-digital converter on the host (data sheet, chapter 24). hal/board/avr_adc.h explains
// its registers.
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
  /// Returns the result in the format of the register ADC: left-adjusted if ADLAR is set.
  uint16_t data() const;

  /// Returns the conversion result of the selected channel. Reads the pin now, although the chip samples it
  /// only `late` ns from now. Pass 0 for analogRead(), which waits until the time of the sample.
  uint16_t sample(SimTime late);
  /// Connects the converter's capacitor to the selected channel from now on. Call this function when the
  /// selection changes and after a conversion.
  void charge() { charges_since_ = state.now; }
  /// Returns the conversion result for a voltage at the selected reference.
  uint16_t code_of(double volts) const;
  /// Returns the duration of one ADC clock.
  SimTime clock() const { return cycles(avr::adc_prescaler(control_)); }
  /// Returns the time at which a conversion that is requested now begins: the next ADC clock.
  SimTime next_start() const { return next_start(clock()); }
  SimTime next_start(SimTime clock) const {
    const SimTime past = state.now - clock_began_;
    return clock_began_ + (past + clock - 1) / clock * clock;
  }
  bool on() const { return control_ & kAden; }
  /// Returns whether a conversion that starts now is the first one since ADEN was set, and records its start.
  /// The first conversion takes longer (24.4). Exception: if the core's init() has set ADEN, the first
  /// analogRead() takes the usual time. The longer time would change the traces of all sketches.
  bool take_first(bool of_analog_read) {
    const bool first = of_analog_read ? first_ == First::by_sketch : first_ != First::over;
    first_ = First::over;
    return first;
  }
  void enabled_by_init() { first_ = First::by_init; }
  /// Ends a conversion with the result `code`, and reads ADCL and ADCH. Returns the previous result if ADCL
  /// was locked.
  uint16_t end_with(uint16_t code) {
    if (!locked_) code_ = code;
    locked_ = false;
    return code_;
  }
  /// Handles a read of ADCL. ADCL and ADCH then do not change until ADCH is read (24.9.3).
  void lock() { locked_ = true; }
  void unlock() { locked_ = false; }

  /// Ends the present conversion if its time is over. In free running mode, starts the next conversion.
  void sync() {
    if (converting_) sync_conversion();
  }
  bool converts() const { return converting_; }
  bool pending() const { return control_ & kAdif && control_ & kAdie; }
  bool may_interrupt() const { return control_ & kAdie && (converting_ || control_ & kAdate); }
  SimTime next() const { return converting_ && control_ & kAdie ? ready_ : kNever; }
  void acknowledge() { control_ &= static_cast<uint8_t>(~kAdif); }

 private:
  void start(SimTime at);
  ROBOSIM_RARE void sync_conversion();
  void look_for_trigger() const;

  uint8_t multiplexer_ = 0, control_ = 0, control_b_ = 0;
  bool converting_ = false, locked_ = false;
  enum class First : uint8_t { over, by_init, by_sketch } first_ = First::over;  ///< who set ADEN, or `over`
  uint16_t code_ = 0, result_ = 0;
  SimTime ready_ = 0;
  AdcCapacitor capacitor_;
  SimTime charges_since_ = 0;  ///< when the capacitor was connected to the selected source
  SimTime clock_began_ = 0;    ///< when the ADC, and with it the ADC clock, was enabled
};

extern Adc adc;

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
