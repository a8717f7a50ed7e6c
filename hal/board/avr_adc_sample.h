// What an AVR's analog-digital converter finds at the pins of a board.
#pragma once

#include "hal/board/avr_adc.h"
#include "hal/board/board_spec.h"
#include "hal/board/firmware_port.h"

namespace robosim {
namespace avr {

/// Samples the channel that ADMUX selects; `wired(pin)` is the number of a pin that its wires are on.
template <typename Wired>
uint16_t adc_sample(FirmwarePort& board, const AdcSpec& adc, uint8_t multiplexer, SimTime t, Wired wired) {
  const BoardSpec& spec = board.spec();
  return adc_sample(adc, multiplexer, 0, spec.supply_volts, board.supply_share(), [&](int channel) {
    const int pin = spec.analog_pin_0 + channel;
    return pin < spec.pin_count ? board.read_volts(wired(static_cast<Pin>(pin)), t) : 0.0;
  });
}

}  // namespace avr
}  // namespace robosim
