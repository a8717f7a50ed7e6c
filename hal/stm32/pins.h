// Maps Arduino's pin numbers to the chip's pins and their other functions (DS5319, table 5).
// hal/board/board_spec.cpp contains the same assignment, and explains it.
#pragma once

#include "hal/stm32/registers.h"

namespace robosim {
namespace stm32 {

struct PinMap {
  uint8_t port;    ///< 0 = A, 1 = B, 2 = C
  uint8_t bit;     ///< 0 to 15; also the number of the pin's EXTI line
  int8_t channel;  ///< channel of ADC1; -1 = none
  uint8_t timer;   ///< timer that can drive the pin by PWM: 1, 3 or 4; 0 = none
  uint8_t output;  ///< channel of that timer, 1 to 4
};

constexpr uint8_t kPins = 32;

/// Returns a pin's entry; null if the number is not a pin.
const PinMap* pin_at(uint8_t number);

inline Address port_of(const PinMap& pin) { return kGpioA + kPortBytes * pin.port; }
/// Returns the four bits of the pin in GPIOx_CRL or GPIOx_CRH (RM0008 9.2.1).
uint32_t configuration(const PinMap& pin);
void configure(const PinMap& pin, uint32_t configuration);
inline bool is_output(uint32_t configuration) { return configuration & 3u; }
/// Returns whether a timer or USART drives the pin.
inline bool is_alternate(uint32_t configuration) { return is_output(configuration) && configuration & 8u; }

/// Sets the level by GPIOx_BSRR, in one write (RM0008 9.2.5).
inline void write_pin(const PinMap& pin, bool level) {
  at(port_of(pin) + kBsrr) = 1u << (level ? pin.bit : pin.bit + 16u);
}
inline bool read_pin(const PinMap& pin) { return load(bit_band(port_of(pin) + kIdr, pin.bit)) != 0; }

/// Enables the clocks of ports A to C and AFIO. Disables JTAG, so that PA15, PB3 and PB4 become ordinary pins
/// (RM0008 9.3.5). SWD stays enabled.
void start_pins();
/// Inverts the pin's output level without changing other pins of the port.
void toggle_pin(const PinMap& pin);

}  // namespace stm32
}  // namespace robosim
