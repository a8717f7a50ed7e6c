// Models the registers TIFR and TIMSK, which the timers of an ATtiny85 share (data sheet 2586Q, 11.9.7,
// 11.9.8, 12.3.7, 12.3.8).
#pragma once

#include <cstdint>
#include <vector>

#include "sim/mcu/avr/core.h"

namespace robosim::avr {

class Timer;

class SharedTimerFlags final : public Peripheral {
 public:
  SharedTimerFlags(Core& core, Address flags, Address enables);
  void add(Timer& timer) { timers_.push_back(&timer); }

  void reset(Cycle) override {}

 private:
  std::uint8_t read_flags(Address address);
  void write_flags(Address address, std::uint8_t value);
  ReadForecast forecast_of_flags(Address address, std::uint8_t bits);
  void write_enables(Address address, std::uint8_t value);

  Core& core_;
  std::vector<Timer*> timers_;
};

}  // namespace robosim::avr
