#include "sim/exec/stm32/remap.h"

namespace robosim::exec::stm32 {

namespace {

constexpr int kA = 0, kB = 1;

}  // namespace

ChipPin timer_pin(int timer, int channel, std::uint32_t map, ChipPin usual) {
  switch (timer) {
    case 1:  // table 46
      return (map >> 6 & 3) == 3 ? kNoChipPin : usual;
    case 2: {  // table 44
      constexpr ChipPin kFirst[] = {{kA, 15}, {kB, 3}}, kSecond[] = {{kB, 10}, {kB, 11}};
      if (channel < 2) return map & 1u << 8 ? kFirst[channel] : usual;
      return map & 1u << 9 ? kSecond[channel - 2] : usual;
    }
    case 3: {  // table 43
      constexpr ChipPin kPartial[] = {{kB, 4}, {kB, 5}};
      const std::uint32_t bits = map >> 10 & 3;
      if (bits == 3) return kNoChipPin;
      return bits == 2 && channel < 2 ? kPartial[channel] : usual;
    }
    default:  // table 42
      return map & 1u << 12 ? kNoChipPin : usual;
  }
}

ChipPin complementary_pin(int channel, std::uint32_t map) {
  constexpr ChipPin kUsual[] = {{kB, 13}, {kB, 14}, {kB, 15}}, kPartial[] = {{kA, 7}, {kB, 0}, {kB, 1}};
  const std::uint32_t bits = map >> 6 & 3;
  if (channel > 2 || bits == 3) return kNoChipPin;
  return bits == 1 ? kPartial[channel] : kUsual[channel];
}

// Returns the TX pin of a USART by tables 48 to 50.
ChipPin usart_pin(int number, std::uint32_t map, ChipPin usual) {
  if (number == 1) return map & 1u << 2 ? ChipPin{kB, 6} : usual;
  const bool elsewhere = number == 2 ? map & 1u << 3 : map & 3u << 4;
  return elsewhere ? kNoChipPin : usual;
}

// Returns the pins of an SPI by table 53.
SpiPins spi_pins(int number, std::uint32_t map) {
  if (number == 2) return {{kB, 13}, {kB, 15}, {kB, 14}, {kB, 12}};
  if (map & 1u << 0) return {{kB, 3}, {kB, 5}, {kB, 4}, {kA, 15}};
  return {{kA, 5}, {kA, 7}, {kA, 6}, {kA, 4}};
}

// Returns the pins of an I2C by table 52.
I2cPins i2c_pins(int number, std::uint32_t map) {
  if (number == 2) return {{kB, 10}, {kB, 11}};
  if (map & 1u << 1) return {{kB, 8}, {kB, 9}};
  return {{kB, 6}, {kB, 7}};
}

// Returns whether the debug port uses a pin, by table 38.
bool is_debuggers(ChipPin pin, std::uint32_t map) {
  const std::uint32_t freed = map >> 24 & 7;
  if (pin.port == kA && (pin.bit == 13 || pin.bit == 14)) return freed < 4;
  if (pin == ChipPin{kA, 15} || pin == ChipPin{kB, 3}) return freed < 2;
  return pin == ChipPin{kB, 4} && freed < 1;
}

}  // namespace robosim::exec::stm32
