// Tests timer 4 of an ATmega32U4 (data sheet 7766J, chapter 15).
#include <gtest/gtest.h>

#include "hal/board/atmega32u4.h"
#include "tests/unit/avr/idle_chip.h"

namespace robosim::avr {
namespace high_speed_timer_test {

constexpr Address kTifr4 = 0x39, kTimsk4 = 0x72, kTcnt4 = 0xBE, kTc4h = 0xBF, kTccr4a = 0xC0, kTccr4b = 0xC1,
                  kTccr4c = 0xC2, kTccr4d = 0xC3, kOcr4a = 0xCF, kOcr4c = 0xD1, kOcr4d = 0xD2;
constexpr Address kPinc = 0x26, kDdrc = 0x27, kPind = 0x29, kDdrd = 0x2A;
constexpr std::uint8_t kOcf4d = 0x80, kOcf4a = 0x40, kTov4 = 0x04, kPc7 = 0x80, kPd7 = 0x80;
constexpr std::uint8_t kBy1 = 1, kBy8 = 4, kBy64 = 7;
constexpr int kMatchA = 38, kMatchD = 40, kOverflow = 41;

class HighSpeedTimerTest : public testing::Test, protected IdleChip {
 protected:
  HighSpeedTimerTest() : IdleChip(kAtmega32u4) {}
  void write_wide(Address low, unsigned value) {
    write(kTc4h, static_cast<std::uint8_t>(value >> 8));
    write(low, static_cast<std::uint8_t>(value));
  }
  unsigned count() {
    const unsigned low = read(kTcnt4);
    return static_cast<unsigned>(read(kTc4h)) << 8 | low;
  }
  /// Runs for `cycles`. Returns the number of these cycles in which a pin's bit reads 1.
  int high(Address pins, std::uint8_t bit, int cycles) {
    int high = 0;
    for (int i = 0; i < cycles / 2; ++i) {
      run(2);
      high += read(pins) & bit ? 2 : 0;
    }
    return high;
  }
};

// If PWM4x = 0, the timer counts to OCR4C and overflows there (table 15-6, 15.8.1). Writes to OCR4x take
// effect immediately.
TEST_F(HighSpeedTimerTest, CountsUpToOcr4cAndOverflowsThere) {
  write_wide(kOcr4c, 0x2FF);
  write_wide(kOcr4a, 0x100);
  write(kTccr4b, kBy8);
  run(8 * 0x200);
  EXPECT_NEAR(count(), 0x200u, 1u);
  EXPECT_EQ(read(kTifr4) & (kOcf4a | kTov4), kOcf4a);
  write(kTifr4, kOcf4a);
  EXPECT_EQ(read(kTifr4) & (kOcf4a | kTov4), 0);
  run(8 * 0x110);
  EXPECT_NEAR(count(), 0x10u, 1u);
  EXPECT_EQ(read(kTifr4) & kTov4, kTov4);
  write_wide(kTcnt4, 0x2F0);
  EXPECT_EQ(count(), 0x2F0u);
}

TEST_F(HighSpeedTimerTest, InterruptsAndAFlagSetBeforeIsServed) {
  write(kOcr4d, 20);
  write(kTccr4b, kBy1);
  run(300);
  EXPECT_EQ(read(kTifr4) & (kOcf4d | kTov4), kOcf4d | kTov4);
  write(kTimsk4, kOcf4d);
  let_interrupts();
  run(20);
  EXPECT_EQ(vector(), kMatchD);
  EXPECT_EQ(read(kTifr4) & (kOcf4d | kTov4), kTov4);
  write(kTimsk4, kTov4);
  let_interrupts();
  run(20);
  EXPECT_EQ(vector(), kOverflow);
  write(kTimsk4, kOcf4a);
  write(kTifr4, kOcf4a);
  write(kTcnt4, 200);
  let_interrupts();
  run(40);
  EXPECT_EQ(vector(), kOverflow) << "the match is not due yet";
  run(40);
  EXPECT_EQ(vector(), kMatchA);
}

TEST_F(HighSpeedTimerTest, PinsReadTheLevelThatItsPwmHas) {
  write(kDdrc, kPc7);
  write(kDdrd, kPd7);
  write(kTccr4b, kBy1);
  write(kTccr4d, 1);  // phase and frequency correct
  write(kTccr4a, 0x82);
  write(kTccr4c, 0x89);
  write(kOcr4a, 51);
  write(kOcr4d, 204);
  run(2000);
  EXPECT_NEAR(high(kPinc, kPc7, 5100), 1020, 20);
  EXPECT_NEAR(high(kPind, kPd7, 5100), 4080, 20);
  EXPECT_TRUE(bench.drives[pin('C', 7)].pwm);
  EXPECT_EQ(bench.drives[pin('C', 7)].duty, 0.2);
}

TEST_F(HighSpeedTimerTest, TogglesAPinAtEachMatch) {
  write(kDdrc, kPc7);
  write(kTccr4a, 0x40);
  write(kTccr4b, kBy64);
  EXPECT_FALSE(bench.drives[pin('C', 7)].level);
  run(64 * 130);
  EXPECT_TRUE(bench.drives[pin('C', 7)].level);
  run(64 * 256);
  EXPECT_FALSE(bench.drives[pin('C', 7)].level);
}

TEST_F(HighSpeedTimerTest, StandsWhilePrrStopsIt) {
  constexpr Address kPrr1 = 0x65;
  write(kTccr4b, kBy8);
  run(800);
  const unsigned before = count();
  write(kPrr1, 0x10);
  EXPECT_EQ(read(kTcnt4), 0);
  run(800);
  write(kPrr1, 0);
  EXPECT_NEAR(count(), before, 1u);
}

}  // namespace high_speed_timer_test
}  // namespace robosim::avr
