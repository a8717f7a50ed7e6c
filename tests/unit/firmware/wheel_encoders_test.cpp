#include "WheelEncoders.h"

#include <gtest/gtest.h>

namespace wheel_encoders_test {

class WheelEncodersTest : public testing::Test {
 protected:
  WheelEncodersTest() {
    fake::board = {};
    encoders.begin();
    encoders.setDirections(1, 1);
    encoders.takeLeft();
    encoders.takeRight();
  }

  static void edges(std::uint8_t pin, int count) {
    for (int i = 0; i < count; ++i) fake::board.pins[pin].handler();
  }

  static constexpr std::uint8_t kLeft = 2, kRight = 3;
  WheelEncoders encoders{kLeft, kRight};
};

TEST_F(WheelEncodersTest, ListenToBothEdgesWithPullUps) {
  for (const std::uint8_t pin : {kLeft, kRight}) {
    EXPECT_EQ(fake::board.pins[pin].mode, INPUT_PULLUP);
    EXPECT_EQ(fake::board.pins[pin].handler_mode, CHANGE);
  }
}

TEST_F(WheelEncodersTest, CountEachWheelOnceInTheDirectionInWhichItIsDriven) {
  edges(kLeft, 5);
  edges(kRight, 3);
  EXPECT_EQ(encoders.takeLeft(), 5);
  EXPECT_EQ(encoders.takeRight(), 3);
  EXPECT_EQ(encoders.takeLeft(), 0);
  EXPECT_EQ(encoders.takeRight(), 0);
  encoders.setDirections(-100, 100);
  edges(kLeft, 4);
  edges(kRight, 2);
  EXPECT_EQ(encoders.takeLeft(), -4);
  EXPECT_EQ(encoders.takeRight(), 2);
  encoders.setDirections(100, -1);
  edges(kLeft, 1);
  edges(kRight, 6);
  EXPECT_EQ(encoders.takeLeft(), 1);
  EXPECT_EQ(encoders.takeRight(), -6);
}

TEST_F(WheelEncodersTest, TakeAWheelThatIsBrakedToRunOnAsItDid) {
  encoders.setDirections(-100, -100);
  encoders.setDirections(0, 0);
  edges(kLeft, 2);
  edges(kRight, 2);
  EXPECT_EQ(encoders.takeLeft(), -2);
  EXPECT_EQ(encoders.takeRight(), -2);
}

}  // namespace wheel_encoders_test
