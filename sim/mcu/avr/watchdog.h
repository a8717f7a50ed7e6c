// Models the watchdog (data sheet DS40002061B, 11.8 and 11.9.2).
//
//   timeout     (2048 << WDP) cycles of 128 kHz after WDR, or after the last timeout: 16 ms to 8 s
//
//   WDE  WDIE   (WDTON is not programmed)
//   0    0      stopped
//   0    1      each timeout sets WDIF
//   1    0      a timeout resets the chip, with WDRF in MCUSR
//   1    1      a timeout sets WDIF; entering the vector clears WDIE. The next timeout then resets the chip.
//               A timeout before the vector is entered also resets the chip
//
// Firmware can clear WDE and change WDP only within 4 cycles after setting WDCE and WDE together. Firmware
// can set WDE, and change WDIE, at any time. While WDRF is set, WDE stays set: after a watchdog reset, the
// watchdog continues with 16 ms. The watchdog runs in all sleep modes, on its own clock.
#pragma once

#include <cstdint>

#include "sim/mcu/avr/core.h"

namespace robosim::avr {

class Watchdog final : public Peripheral {
 public:
  explicit Watchdog(Core& core);

  void reset(Cycle at) override;
  std::uint64_t may_interrupt() const override;

 private:
  struct State {
    Cycle origin = 0;          ///< cycle at which the current timeout started
    Cycle unlocked_until = 0;  ///< WDCE reads 1 up to this cycle
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
