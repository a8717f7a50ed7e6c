#include "PushButton.h"

#include <gtest/gtest.h>

namespace push_button_test {

constexpr std::uint8_t kPin = 4;

class PushButtonTest : public ::testing::Test {
 protected:
  void SetUp() override {
    fake::board = fake::Board{};
    fake::board.pins[kPin].reads = HIGH;
    button.begin();
  }

  // Keeps the pin at `level` for `ms`. The button reads the pin every millisecond.
  void hold(int level, int ms) {
    fake::board.pins[kPin].reads = level;
    for (int i = 0; i < ms; ++i) {
      fake::board.now_us += 1000;
      button.update();
      presses += button.wasPressed();
      releases += button.wasReleased();
    }
  }

  PushButton button{kPin};
  int presses = 0;
  int releases = 0;
};

TEST_F(PushButtonTest, UsesThePullUpOfTheChip) { EXPECT_EQ(fake::board.pins[kPin].mode, INPUT_PULLUP); }

TEST_F(PushButtonTest, CountsAPressOnceAndOnlyWhenItHasLasted) {
  hold(LOW, 15);
  EXPECT_FALSE(button.isPressed());
  hold(LOW, 100);
  EXPECT_TRUE(button.isPressed());
  EXPECT_EQ(presses, 1);
  EXPECT_EQ(releases, 0);
  hold(HIGH, 100);
  EXPECT_FALSE(button.isPressed());
  EXPECT_EQ(presses, 1);
  EXPECT_EQ(releases, 1);
}

TEST_F(PushButtonTest, SeesOnePressWhereContactsBounce) {
  for (int i = 0; i < 6; ++i) {
    hold(LOW, 3);
    hold(HIGH, 2);
  }
  EXPECT_EQ(presses, 0);
  hold(LOW, 50);
  for (int i = 0; i < 6; ++i) {
    hold(HIGH, 3);
    hold(LOW, 2);
  }
  EXPECT_EQ(presses, 1);
  EXPECT_EQ(releases, 0);
}

TEST_F(PushButtonTest, KnowsHowLongItIsHeld) {
  hold(LOW, 20);
  hold(LOW, 500);
  EXPECT_NEAR(button.heldFor(), 500, 2);
}

TEST_F(PushButtonTest, IsPressedAtOnceIfHeldAtPowerOn) {
  fake::board.pins[kPin].reads = LOW;
  button.begin();
  EXPECT_TRUE(button.isPressed());
  EXPECT_FALSE(button.wasPressed());
}

TEST_F(PushButtonTest, TakesAButtonToTheSupply) {
  PushButton high(6, PushButton::PressedIs::high);
  high.begin();
  EXPECT_EQ(fake::board.pins[6].mode, INPUT);
  EXPECT_FALSE(high.isPressed());
  fake::board.pins[6].reads = HIGH;
  high.begin();
  EXPECT_TRUE(high.isPressed());
}

TEST_F(PushButtonTest, DebouncesAcrossTheWrapAroundOfItsClock) {
  fake::board.millis_at_start = 0xFFFFFFF8u;  // millis() wraps in 8 ms, as after 49.7 days
  button.begin();
  hold(LOW, 15);
  EXPECT_EQ(presses, 0);
  hold(LOW, 100);
  EXPECT_EQ(presses, 1);
}

}  // namespace push_button_test
