#include "ShiftRegisters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace shift_registers_test {

using testing::ElementsAre;

class ShiftRegistersTest : public testing::Test {
 protected:
  ShiftRegistersTest() {
    fake::board = {};
    out.begin();
    fake::board.shifted.clear();
    fake::board.pins[kLatch].rises = 0;
  }
  static constexpr std::uint8_t kData = 11, kClock = 13, kLatch = 10;
  ShiftRegisters out{kData, kClock, kLatch, 3};
};

TEST_F(ShiftRegistersTest, BeginMakesThePinsOutputsAndAllOutputsLow) {
  fake::board = {};
  ShiftRegisters(kData, kClock, kLatch, 2).begin();
  for (const std::uint8_t pin : {kData, kClock, kLatch}) EXPECT_EQ(fake::board.pins[pin].mode, OUTPUT);
  EXPECT_THAT(fake::board.shifted, ElementsAre(0, 0));
  EXPECT_EQ(fake::board.pins[kLatch].rises, 1);
}

TEST_F(ShiftRegistersTest, ShowSendsTheFarthestByteFirstAndLatchesOnce) {
  out.set(0, 0x11);
  out.set(1, 0x22);
  out.set(2, 0x33);
  EXPECT_THAT(fake::board.shifted, ElementsAre()) << "set() alone sends nothing";
  out.show();
  EXPECT_THAT(fake::board.shifted, ElementsAre(0x33, 0x22, 0x11));
  EXPECT_EQ(fake::board.pins[kLatch].rises, 1);
  EXPECT_EQ(fake::board.pins[kLatch].level, LOW);
}

TEST_F(ShiftRegistersTest, RegistersThatDoNotExistAreNotTouched) {
  out.set(200, 0xFF);
  EXPECT_EQ(out.get(200), 0);
  out.show();
  EXPECT_THAT(fake::board.shifted, ElementsAre(0, 0, 0));
}

}  // namespace shift_registers_test
