#include "ClockedReceiver.h"

#include <gtest/gtest.h>

namespace clocked_receiver_test {

class ClockedReceiverTest : public testing::Test {
 protected:
  ClockedReceiverTest() {
    fake::board = {};
    radio.begin();
  }

  void enable(int level) {
    fake::board.pins[kEnable].reads = level;
    fake::board.pins[kEnable].handler();
  }
  void bit(bool one) {
    fake::board.pins[kData].reads = one ? HIGH : LOW;
    fake::board.pins[kClock].handler();
  }
  void message(unsigned bits, int count) {
    enable(HIGH);
    for (int i = count - 1; i >= 0; --i) bit((bits >> i & 1) != 0);
    enable(LOW);
  }

  static constexpr std::uint8_t kData = 5, kClock = 2, kEnable = 3;
  ClockedReceiver radio{kData, kClock, kEnable};
};

TEST_F(ClockedReceiverTest, ListensToRisingClocksAndBothEdgesOfEnable) {
  EXPECT_EQ(fake::board.pins[kClock].handler_mode, RISING);
  EXPECT_EQ(fake::board.pins[kEnable].handler_mode, CHANGE);
}

TEST_F(ClockedReceiverTest, GivesAMessageOnceWithTheMostSignificantBitFirst) {
  EXPECT_FALSE(radio.available());
  message(0xA3, 8);
  ASSERT_TRUE(radio.available());
  EXPECT_EQ(radio.bits(), 8);
  EXPECT_EQ(radio.value(), 0xA3);
  EXPECT_FALSE(radio.available());
}

TEST_F(ClockedReceiverTest, AMessageCountsOnlyWhenEnableHasFallen) {
  enable(HIGH);
  bit(true);
  EXPECT_FALSE(radio.available());
  enable(LOW);
  EXPECT_TRUE(radio.available());
}

TEST_F(ClockedReceiverTest, CountsBitsSoThatAWrongNumberCanBeRefused) {
  message(5, 3);
  ASSERT_TRUE(radio.available());
  EXPECT_EQ(radio.bits(), 3);
  message(0, 0);
  ASSERT_TRUE(radio.available());
  EXPECT_EQ(radio.bits(), 0);
  enable(HIGH);
  for (int i = 0; i < 300; ++i) bit(false);
  enable(LOW);
  ASSERT_TRUE(radio.available());
  EXPECT_EQ(radio.bits(), 255) << "the count stops at 255, and does not wrap round to 44";
}

TEST_F(ClockedReceiverTest, TheNewerOfTwoMessagesCountsAndNoBitOfTheOlder) {
  message(0xFF, 8);
  message(0x01, 8);
  ASSERT_TRUE(radio.available());
  EXPECT_EQ(radio.value(), 1);
  EXPECT_FALSE(radio.available());
}

}  // namespace clocked_receiver_test
