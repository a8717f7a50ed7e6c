// Tests the pull-up resistors, as circuits outside the chip see them.
#include <gtest/gtest.h>

#include "tests/unit/avr/idle_chip.h"

namespace robosim::avr {
namespace pull_ups_test {

constexpr Address kDdrd = 0x2A, kPortd = 0x2B;

TEST(PullUps, AreSwitchedOffAllAtOnce) {
  IdleChip chip;
  const int in = chip.pin('D', 2), out = chip.pin('D', 3);
  chip.write(kDdrd, 0x08);
  chip.write(kPortd, 0x0C);
  EXPECT_EQ(chip.bench.drives[in].mode, PinMode::input_pullup);
  chip.write(reg::kMcucr, kPud);
  EXPECT_EQ(chip.bench.drives[in].mode, PinMode::input);
  EXPECT_EQ(chip.bench.drives[out].mode, PinMode::output);
  EXPECT_TRUE(chip.bench.drives[out].level);
  chip.write(reg::kMcucr, 0);
  EXPECT_EQ(chip.bench.drives[in].mode, PinMode::input_pullup);
}

}  // namespace pull_ups_test
}  // namespace robosim::avr
