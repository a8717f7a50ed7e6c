// Maps peripherals to pins by AFIO_MAPR (RM0008 9.3, 9.4.2). If the package of this chip does not have the
// pin, the result is kNoChipPin.
#pragma once

#include "sim/exec/stm32/link.h"

namespace robosim::exec::stm32 {

/// Returns the pin of a timer channel. `timer` is 1 to 4, and `channel` is 0 to 3. `map` is AFIO_MAPR, and
/// `usual` is the pin after a reset.
ChipPin timer_pin(int timer, int channel, std::uint32_t map, ChipPin usual);
/// Returns the pin of TIM1's complementary output. `channel` is 0 to 2.
ChipPin complementary_pin(int channel, std::uint32_t map);
/// Returns the TX pin of USART `number`; `usual` is the pin after a reset.
ChipPin usart_pin(int number, std::uint32_t map, ChipPin usual);
struct SpiPins {
  ChipPin clock, out, in, select;
};
SpiPins spi_pins(int number, std::uint32_t map);
struct I2cPins {
  ChipPin clock, data;
};
I2cPins i2c_pins(int number, std::uint32_t map);
/// Returns whether JTAG or SWD uses the pin. Firmware cannot use such a pin.
bool is_debuggers(ChipPin pin, std::uint32_t map);

}  // namespace robosim::exec::stm32
