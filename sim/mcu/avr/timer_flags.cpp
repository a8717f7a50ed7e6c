#include "sim/mcu/avr/timer_flags.h"

#include <algorithm>

#include "sim/mcu/avr/timer.h"

namespace robosim::avr {

SharedTimerFlags::SharedTimerFlags(Core& core, Address flags, Address enables) : core_(core) {
  core.cpu.on_read<&SharedTimerFlags::read_flags>(flags, this);
  core.cpu.on_write<&SharedTimerFlags::write_flags>(flags, this);
  core.cpu.on_forecast<&SharedTimerFlags::forecast_of_flags>(flags, this);
  core.cpu.on_write<&SharedTimerFlags::write_enables>(enables, this);
}

std::uint8_t SharedTimerFlags::read_flags(Address address) {
  std::uint8_t flags = 0;
  for (Timer* const timer : timers_) flags |= timer->flags_in_register();
  return core_.at(address) = flags;
}

void SharedTimerFlags::write_flags(Address, std::uint8_t value) {
  for (Timer* const timer : timers_) timer->clear_in_register(value);
}

ReadForecast SharedTimerFlags::forecast_of_flags(Address address, std::uint8_t bits) {
  ReadForecast all{kNoCycle, 0};
  for (Timer* const timer : timers_) {
    const ReadForecast one = timer->forecast_of_flags(address, bits);
    all.until = std::min(all.until, one.until);
  }
  all.value = read_flags(address);
  return all;
}

void SharedTimerFlags::write_enables(Address address, std::uint8_t value) {
  core_.at(address) = value;
  for (Timer* const timer : timers_) timer->enable_in_register(value);
}

}  // namespace robosim::avr
