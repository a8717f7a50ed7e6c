// Samples a board's pins for an AVR's analog-digital converter.
#pragma once

#include "hal/board/avr_adc.h"
#include "hal/board/board_spec.h"
#include "hal/board/firmware_port.h"

namespace robosim {
namespace avr {

/// Returns the conversion result for the channel that ADMUX has selected since `from`. `wired(pin)` returns
/// the pin number under which a pin's wires are stored. `held` is the voltage on the converter's capacitor;
/// the sample updates this voltage. The chip samples at `t` + `late`, but the pin is read at `t`.
template <typename Wired>
uint16_t adc_sample(FirmwarePort& board, const BoardSpec& spec, const AdcSpec& adc, uint8_t multiplexer,
                    double& held, SimTime from, SimTime t, SimTime late, Wired wired) {
  const auto volts = [&](int channel) {
    const int pin = spec.analog_pin_0 + channel;
    return pin < spec.pin_count ? board.convert(wired(static_cast<Pin>(pin)), held, from - late, t) : 0.0;
  };
  const auto share = [&] { return board.supply_share(); };
  return adc_sample(adc, multiplexer, 0, spec.supply_volts, share, volts, held);
}

}  // namespace avr
}  // namespace robosim
