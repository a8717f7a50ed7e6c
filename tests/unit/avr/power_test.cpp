// Tests the sleep modes, above all the number of cycles from a wake-up event to the interrupt handler.
#include <gtest/gtest.h>

#include "tests/unit/avr/idle_chip.h"

namespace robosim::avr {
namespace power_test {

constexpr std::uint8_t kEnable = 1, kIdle = 0, kNoiseReduction = 2, kPowerDown = 4, kPowerSave = 6,
                       kStandby = 12, kExtendedStandby = 14;
constexpr Cycle kWatchdogTime = 256000, kWakes = 4, kEnters = 4;

/// Sleeps in `mode` until the watchdog expires. Returns the number of cycles from the expiry to the first
/// cycle of the watchdog's interrupt handler.
Cycle wakes_after(std::uint8_t mode) {
  IdleChip chip;
  chip.write(reg::kWdtcsr, 0x40);
  chip.write(reg::kSmcr, static_cast<std::uint8_t>(mode | kEnable));
  chip.let_interrupts();
  chip.fall_asleep();
  EXPECT_TRUE(chip.bench.chip.is_asleep());
  chip.run_to(kWatchdogTime + 1);
  EXPECT_FALSE(chip.bench.chip.is_asleep());
  EXPECT_EQ(chip.vector(), 6);
  return chip.now() - kWatchdogTime;
}

TEST(Power, WakingCostsFourCyclesAndTheStartUpTimeOfTheSleepMode) {
  EXPECT_EQ(wakes_after(kIdle), kWakes + kEnters);
  EXPECT_EQ(wakes_after(kNoiseReduction), kWakes + kEnters);
  EXPECT_EQ(wakes_after(kPowerDown), 16384 + kWakes + kEnters);
  EXPECT_EQ(wakes_after(kPowerSave), 16384 + kWakes + kEnters);
  EXPECT_EQ(wakes_after(kStandby), 6 + kWakes + kEnters);
  EXPECT_EQ(wakes_after(kExtendedStandby), 6 + kWakes + kEnters);
}

TEST(Power, AChipThatSleepsWithInterruptsOffIsOffUnlessTheWatchdogResets) {
  IdleChip chip;
  chip.write(reg::kSmcr, kPowerDown | kEnable);
  chip.fall_asleep();
  EXPECT_EQ(chip.bench.run(1000), Chip::Stop::off);

  IdleChip watched;
  watched.write(reg::kWdtcsr, 0x08);
  watched.write(reg::kSmcr, kPowerDown | kEnable);
  watched.fall_asleep();
  EXPECT_EQ(watched.bench.run(1000), Chip::Stop::reached);
  watched.run(kWatchdogTime);
  EXPECT_EQ(watched.bench.resets, 1);
  EXPECT_FALSE(watched.bench.chip.is_asleep());
}

TEST(Power, SleepIsCounted) {
  IdleChip chip;
  chip.write(reg::kWdtcsr, 0x40);
  chip.write(reg::kSmcr, kIdle | kEnable);
  chip.let_interrupts();
  chip.fall_asleep();
  const Cycle from = chip.now();
  chip.run_to(kWatchdogTime + 1000);
  EXPECT_EQ(chip.bench.chip.sleep_cycles(), kWatchdogTime + kWakes - from);
}

}  // namespace power_test
}  // namespace robosim::avr
