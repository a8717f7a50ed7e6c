// Models the watchdog (data sheet DS40002061B, 11.8 and 11.9.2). hal/board/avr_watchdog.h describes its
// modes. After WDCE is set, firmware can change the mode within 4 cycles. After a watchdog reset, the timeout
// is 16 ms. The watchdog runs in all sleep modes, on its own clock.
#pragma once

#include <cstdint>

#include "hal/board/avr_watchdog.h"
#include "sim/mcu/avr/core.h"

namespace robosim::avr {

class Watchdog final : public Peripheral {
 public:
  explicit Watchdog(Core& core);

  void reset(Cycle at) override;
  std::uint64_t may_interrupt() const override;

 private:
  using State = WatchdogControl<Cycle>;

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
