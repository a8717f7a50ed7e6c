// Maps peripherals to pins by AFIO_MAPR (RM0008 9.3, 9.4.2), limited to the pins of this chip's package.
#pragma once

#include "sim/exec/stm32/link.h"

namespace robosim::exec::stm32 {

/// Returns the pin of a timer channel. `timer` is 1 to 4, `channel` 0 to 3; `usual` is the pin after a reset.
ChipPin timer_pin(int timer, int channel, std::uint32_t map, ChipPin usual);
/// Returns the pin of TIM1's complementary output for channels 0 to 2.
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
/// Returns whether JTAG or SWD uses the pin, which then is not a general pin.
bool is_debuggers(ChipPin pin, std::uint32_t map);

}  // namespace robosim::exec::stm32
