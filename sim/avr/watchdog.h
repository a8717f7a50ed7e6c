// The watchdog. Data sheet DS40002061B, 11.8 and 11.9.2.
//
//   timeout     (2048 << WDP) cycles of 128 kHz after WDR, or after the last timeout: 16 ms to 8 s
//
//   WDE  WDIE   (WDTON is not programmed)
//   0    0      stopped
//   0    1      WDIF is set, at each timeout
//   1    0      the chip is reset: WDRF in MCUSR
//   1    1      WDIF is set; its vector clears WDIE, so that the next timeout resets, and so does a timeout
//               before the vector was entered
//
// WDE is cleared, and WDP changed, within 4 cycles of writing WDCE and WDE together. WDE may be set, and WDIE
// changed, at any time. WDRF holds WDE: after a watchdog reset it runs on, with 16 ms. It runs in all sleep
// modes, by its own clock.
#pragma once

#include <cstdint>

#include "sim/avr/core.h"

namespace robosim::avr {

class Watchdog final : public Peripheral {
 public:
  explicit Watchdog(Core& core);

  void reset(Cycle at) override;
  std::uint64_t may_interrupt() const override;

 private:
  struct State {
    Cycle origin = 0;          ///< when it began to count
    Cycle unlocked_until = 0;  ///< WDCE reads 1 before
  };

  std::uint8_t read(Address address);
  void write(Address address, std::uint8_t value);
  void restart();
  void schedule();
  void timed_out(Cycle at);
  void entered(int vector);
  void clock_changed(std::int64_t hz_before);
  void request();
  bool held() const;
  Cycle period() const;

  Core& core_;
  const Address control_;  ///< WDTCSR
  Events::Id timed_out_ = 0;
  State state_;
};

}  // namespace robosim::avr
