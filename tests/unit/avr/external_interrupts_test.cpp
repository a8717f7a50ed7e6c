// Tests external interrupts. Also tests the set of pins whose edges the environment must report to the chip.
#include <gtest/gtest.h>

#include "tests/unit/avr/idle_chip.h"

namespace robosim::avr {
namespace external_interrupts_test {

constexpr std::uint8_t kLowLevel = 0, kFalling = 2, kRising = 3;
constexpr std::uint8_t kPowerDown = 4;
constexpr int kInt0Vector = 1, kPinChange2Vector = 5;
constexpr Cycle kStartUp = 16384;

class ExternalInterruptsTest : public testing::Test, protected IdleChip {
 protected:
  int int0 = pin('D', 2);
};

TEST_F(ExternalInterruptsTest, ListenOnlyOnceTheyAreAskedFor) {
  EXPECT_FALSE(bench.listens_to[int0]);
  write(reg::kEicra, kRising);
  EXPECT_TRUE(bench.listens_to[int0]);
  EXPECT_FALSE(bench.listens_to[pin('D', 3)]);
  write(reg::kEicra, kLowLevel);
  EXPECT_FALSE(bench.listens_to[int0]);
  write(reg::kEimsk, 1);
  EXPECT_TRUE(bench.listens_to[int0]);
  write(reg::kEimsk, 0);
  EXPECT_FALSE(bench.listens_to[int0]);
}

TEST_F(ExternalInterruptsTest, PinChangesListenToPinsOfTheirMask) {
  write(reg::kPcicr, 0x04);
  EXPECT_FALSE(bench.listens_to[int0]);
  write(reg::kPcmsk2, 0x04);
  EXPECT_TRUE(bench.listens_to[int0]);
  EXPECT_FALSE(bench.listens_to[pin('D', 4)]);
  write(reg::kPcmsk2, 0);
  EXPECT_FALSE(bench.listens_to[int0]);
}

TEST_F(ExternalInterruptsTest, ARisingEdgeIsServed) {
  bench.levels[int0] = false;
  write(reg::kEicra, kRising);
  write(reg::kEimsk, 1);
  let_interrupts();
  run(100);
  EXPECT_EQ(vector(), 0);
  bench.set_level(int0, true);
  run(20);
  EXPECT_EQ(vector(), kInt0Vector);
  EXPECT_EQ(read(reg::kEifr), 0);
}

TEST_F(ExternalInterruptsTest, AFallingEdgeIsNoRisingOne) {
  bench.levels[int0] = true;
  write(reg::kEicra, kRising);
  bench.set_level(int0, false);
  run(20);
  EXPECT_EQ(read(reg::kEifr), 0);
  bench.set_level(int0, true);
  run(20);
  EXPECT_EQ(read(reg::kEifr), 1);
}

TEST_F(ExternalInterruptsTest, ALowLevelThatIsThereAlreadyIsServed) {
  bench.levels[int0] = false;
  write(reg::kEimsk, 1);
  let_interrupts();
  run(20);
  EXPECT_EQ(vector(), kInt0Vector);
  EXPECT_TRUE(bench.chip.core().interrupts.is_requested(kInt0Vector));
  bench.set_level(int0, true);
  EXPECT_FALSE(bench.chip.core().interrupts.is_requested(kInt0Vector));
}

TEST_F(ExternalInterruptsTest, APinChangeWakesFromPowerDown) {
  bench.levels[int0] = false;
  write(reg::kPcmsk2, 0x04);
  write(reg::kPcicr, 0x04);
  let_interrupts();
  run(100);
  write(reg::kSmcr, kSe | kPowerDown);
  fall_asleep();
  run(1000);
  ASSERT_TRUE(bench.chip.is_asleep());
  bench.set_level(int0, true);
  const Cycle from = now();
  run(10);
  EXPECT_EQ(vector(), kPinChange2Vector);
  EXPECT_NEAR(static_cast<double>(now()), static_cast<double>(from + 3 + kStartUp + 4 + 4), 10);
}

TEST_F(ExternalInterruptsTest, AnEdgeOfIntWakesFromPowerDownToo) {
  bench.levels[int0] = true;
  write(reg::kEicra, kFalling);
  write(reg::kEimsk, 1);
  let_interrupts();
  run(100);
  write(reg::kSmcr, kSe | kPowerDown);
  fall_asleep();
  bench.set_level(int0, false);
  run(20000);
  EXPECT_FALSE(bench.chip.is_asleep());
  EXPECT_EQ(vector(), kInt0Vector);
}

TEST_F(ExternalInterruptsTest, ALowLevelWakesFromPowerDown) {
  bench.levels[int0] = true;
  write(reg::kEimsk, 1);
  let_interrupts();
  run(100);
  write(reg::kSmcr, kSe | kPowerDown);
  fall_asleep();
  run(100);
  bench.set_level(int0, false);
  run(20000);
  EXPECT_FALSE(bench.chip.is_asleep());
  EXPECT_EQ(vector(), kInt0Vector);
}

TEST_F(ExternalInterruptsTest, NothingIsHeardBehindAReset) {
  write(reg::kEicra, kRising);
  write(reg::kPcmsk0, 0xFF);
  bench.chip.reset(0x02);
  EXPECT_FALSE(bench.listens_to[int0]);
  EXPECT_FALSE(bench.listens_to[pin('B', 0)]);
}

}  // namespace external_interrupts_test
}  // namespace robosim::avr
