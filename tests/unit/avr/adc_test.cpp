// Tests the time at which the ADC samples a voltage, and the digital code of this voltage.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/avr/idle_chip.h"

namespace robosim::avr {
namespace adc_test {

using testing::ElementsAre;
using testing::Pair;

constexpr std::uint8_t kBy128 = 7;
constexpr std::uint8_t kSupply = 0x40;

class AdcTest : public testing::Test, protected IdleChip {
 protected:
  int code() {
    const int low = read(reg::kAdcL);
    return read(reg::kAdcH) << 8 | low;
  }
};

TEST_F(AdcTest, TheFirstConversionSamplesAfter13AndAHalfClocks) {
  write(reg::kAdmux, kSupply | 3);
  write(reg::kAdcsra, kAden | kAdsc | kBy128);
  run(4000);
  EXPECT_THAT(bench.samples, ElementsAre(Pair(64 + 27 * 64, 3)));
}

TEST_F(AdcTest, FurtherConversionsSampleAfterOneAndAHalf) {
  write(reg::kAdcsra, kAden | kAdsc | kAdate | kBy128);
  run(6000);
  constexpr int kEnd = 64 + 25 * 128;
  EXPECT_THAT(bench.samples,
              ElementsAre(Pair(64 + 27 * 64, 0), Pair(kEnd + 3 * 64, 0), Pair(kEnd + 13 * 128 + 3 * 64, 0)));
}

TEST_F(AdcTest, AVoltageBecomesItsCode) {
  bench.voltages[5] = 1.25;
  write(reg::kAdmux, kSupply | 5);
  write(reg::kAdcsra, kAden | kAdsc | kBy128);
  run(4000);
  EXPECT_EQ(code(), 256);
}

TEST_F(AdcTest, AStoppedClockHoldsTheConversion) {
  write(reg::kAdcsra, kAden | kAdsc | kBy128);
  run(1000);
  const Cycle stopped = now();
  write(reg::kPrr, 1);
  run(10000);
  write(reg::kPrr, 0);
  const Cycle stood = now() - stopped;
  run(4000);
  EXPECT_THAT(bench.samples, ElementsAre(Pair(64 + 27 * 64 + stood, 0)));
  EXPECT_EQ(read(reg::kAdcsra), kAden | kAdif | kBy128);
}

TEST_F(AdcTest, AChosenTriggerThatIsSetAlreadyIsAnEdge) {
  write(reg::kEicra, 1);
  write(0x2A, 0x04);  // DDRD
  write(0x2B, 0x04);  // PORTD: INT0
  run(10);
  ASSERT_EQ(read(reg::kEifr), 1);
  write(reg::kAdcsra, kAden | kAdate);
  write(reg::kAdcsrb, 1);
  EXPECT_EQ(read(reg::kAdcsra), kAden | kAdate);
  write(reg::kAdcsrb, 2);
  EXPECT_EQ(read(reg::kAdcsra), kAden | kAdate | kAdsc);
}

TEST_F(AdcTest, NothingIsLeftOfAConversionBehindAReset) {
  write(reg::kAdcsra, kAden | kAdsc | kBy128);
  run(1000);
  bench.chip.reset(0x02);
  run(4000);
  EXPECT_TRUE(bench.samples.empty());
  EXPECT_EQ(read(reg::kAdcsra), 0);
}

}  // namespace adc_test
}  // namespace robosim::avr
