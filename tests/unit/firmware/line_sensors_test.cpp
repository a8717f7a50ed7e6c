#include "LineSensors.h"

#include <gtest/gtest.h>

#include <array>

namespace line_sensors_test {

constexpr std::uint8_t kFive[] = {14, 15, 16, 17, 18};

class LineSensorsTest : public ::testing::Test {
 protected:
  void SetUp() override { fake::board = fake::Board{}; }

  // Sets the values that analogRead() returns for the five pins kFive.
  static void see(int a, int b, int c, int d, int e) {
    const int values[] = {a, b, c, d, e};
    for (int i = 0; i < 5; ++i) fake::board.pins[kFive[i]].analog = values[i];
  }
};

TEST_F(LineSensorsTest, PutTheLineWhereTheMeanOfWhatTheySeeIs) {
  const std::uint16_t middle[] = {0, 0, 1000, 0, 0};
  const std::uint16_t left_end[] = {1000, 0, 0, 0, 0};
  const std::uint16_t between[] = {0, 0, 0, 600, 600};
  EXPECT_EQ(LineSensors::weightedPosition(middle, 5, 99), 0);
  EXPECT_EQ(LineSensors::weightedPosition(left_end, 5, 99), -2000);
  EXPECT_EQ(LineSensors::weightedPosition(between, 5, 99), 1500);
}

TEST_F(LineSensorsTest, AddUpInMoreThanTheSixteenBitsOfAnUnosInt) {
  // The sum 1000 * 3500 + 1000 * 2500 = 6,000,000 would be -29,312 in 16 bits.
  const std::uint16_t values[] = {0, 0, 0, 0, 0, 0, 1000, 1000};
  EXPECT_EQ(LineSensors::weightedPosition(values, 8, 99), 3000);
  // The product 818 * 100 = 81,800 would be 16,264 in 16 bits.
  EXPECT_EQ(LineSensors::scaled(818, 0, 1023), 799);
  // Times of an RC sensor may be above 32,767 us, the largest 16-bit int.
  EXPECT_EQ(LineSensors::scaled(60000, 20000, 60000), 1000);
}

TEST_F(LineSensorsTest, DoNotCountAFaintReflectionAsLine) {
  const std::uint16_t one_and_dirt[] = {49, 0, 0, 0, 1000};
  const std::uint16_t dirt[] = {199, 100, 0, 0, 0};
  EXPECT_EQ(LineSensors::weightedPosition(one_and_dirt, 5, 99), 2000);
  EXPECT_EQ(LineSensors::weightedPosition(dirt, 5, 99), 99);
}

TEST_F(LineSensorsTest, ScaleBetweenFloorAndLineWhicheverIsLarger) {
  EXPECT_EQ(LineSensors::scaled(450, 100, 800), 500);
  EXPECT_EQ(LineSensors::scaled(450, 800, 100), 500);
  EXPECT_EQ(LineSensors::scaled(50, 100, 800), 0);
  EXPECT_EQ(LineSensors::scaled(900, 100, 800), 1000);
  EXPECT_EQ(LineSensors::scaled(900, 800, 100), 0);
  EXPECT_EQ(LineSensors::scaled(500, 300, 300), 0) << "an empty range must not cause a division by zero";
}

TEST_F(LineSensorsTest, GiveValuesAndPositionFromAnalogPins) {
  AnalogLineSensors sensors(kFive);
  sensors.begin();
  sensors.setRange(100, 900);
  see(100, 100, 500, 900, 100);
  sensors.read();
  EXPECT_EQ(sensors.raw(2), 500);
  EXPECT_EQ(sensors.value(2), 500);
  EXPECT_TRUE(sensors.onLine(3));
  EXPECT_FALSE(sensors.onLine(4));
  EXPECT_TRUE(sensors.seesLine());
  EXPECT_EQ(sensors.position(), 666);
}

TEST_F(LineSensorsTest, GoFromTheLeastToTheMostThatAPinReadsUntilARangeIsSet) {
  AnalogLineSensors sensors(kFive);
  sensors.begin();
  see(0, 1023, 1022, 511, 0);
  sensors.read();
  EXPECT_EQ(sensors.value(0), 0);
  EXPECT_EQ(sensors.value(1), 1000);
  EXPECT_EQ(sensors.value(2), 999);
  EXPECT_EQ(sensors.value(3), 499);
}

TEST_F(LineSensorsTest, TellALineFromWhatIsOnlySeen) {
  AnalogLineSensors sensors(kFive);
  sensors.setRange(0, 1000);
  see(499, 500, 0, 0, 0);
  sensors.read();
  EXPECT_FALSE(sensors.onLine(0));
  EXPECT_TRUE(sensors.onLine(1));
  for (const int reads : {199, 200}) {
    see(0, 0, 0, 0, reads);
    sensors.read();
    EXPECT_EQ(sensors.seesLine(), reads == 200);
  }
}

TEST_F(LineSensorsTest, HaveEachARangeOfTheirOwn) {
  AnalogLineSensors sensors(kFive);
  sensors.setRange(0, 1000);
  sensors.setRange(3, 500, 600);
  sensors.setRange(5, 1, 2);  // there is no sensor 5
  see(550, 550, 550, 550, 550);
  sensors.read();
  for (std::uint8_t i = 0; i < 5; ++i) EXPECT_EQ(sensors.value(i), i == 3 ? 500 : 550) << int{i};
}

TEST_F(LineSensorsTest, RememberOnWhichSideTheLineLeft) {
  AnalogLineSensors sensors(kFive);
  sensors.setRange(0, 1000);
  for (const bool left : {true, false}) {
    left ? see(1000, 0, 0, 0, 0) : see(0, 0, 0, 0, 1000);
    sensors.read();
    see(0, 0, 0, 0, 0);
    for (int i = 0; i < 3; ++i) sensors.read();
    EXPECT_FALSE(sensors.seesLine());
    EXPECT_EQ(sensors.position(), left ? -2000 : 2000);
  }
}

TEST_F(LineSensorsTest, RememberASideOnlyIfTheLineWasBeyondTheLastSensorButOne) {
  AnalogLineSensors sensors(kFive);
  sensors.setRange(0, 1000);
  for (const auto& [fourth, fifth, then] : {std::array{1000, 0, 0}, {990, 60, 2000}}) {
    for (const int side : {-1, 1}) {
      side < 0 ? see(fifth, fourth, 0, 0, 0) : see(0, 0, 0, fourth, fifth);
      sensors.read();
      see(0, 0, 0, 0, 0);
      sensors.read();
      EXPECT_EQ(sensors.position(), side * then);
    }
  }
}

TEST_F(LineSensorsTest, GoStraightOnAcrossAGap) {
  AnalogLineSensors sensors(kFive);
  sensors.setRange(0, 1000);
  see(0, 400, 900, 0, 0);
  sensors.read();
  EXPECT_LT(sensors.position(), 0);
  see(0, 0, 0, 0, 0);
  sensors.read();
  EXPECT_EQ(sensors.position(), 0);
}

TEST_F(LineSensorsTest, FindTheirRangeByCalibration) {
  AnalogLineSensors sensors(kFive);
  sensors.startCalibration();
  see(120, 90, 100, 110, 100);
  sensors.calibrate();
  see(880, 700, 900, 910, 300);
  sensors.calibrate();
  see(500, 395, 500, 510, 200);
  sensors.calibrate();
  sensors.read();
  for (std::uint8_t i = 0; i < 5; ++i) EXPECT_EQ(sensors.value(i), 500) << int{i};
}

TEST_F(LineSensorsTest, FindTheirRangeWhereTheLineReadsLow) {
  AnalogLineSensors sensors(kFive);
  sensors.startCalibration(false);
  see(900, 900, 900, 900, 900);
  sensors.calibrate();
  see(100, 100, 100, 100, 100);
  sensors.calibrate();
  see(100, 900, 900, 900, 900);
  sensors.read();
  EXPECT_TRUE(sensors.onLine(0));
  EXPECT_EQ(sensors.position(), -2000);
}

TEST_F(LineSensorsTest, TakeDigitalSensorsOfEitherPolarity) {
  constexpr std::uint8_t pins[] = {2, 3, 4};
  DigitalLineSensors high(pins, HIGH);
  DigitalLineSensors low(pins, LOW);
  fake::board.pins[2].reads = HIGH;
  high.read();
  low.read();
  EXPECT_TRUE(high.onLine(0));
  EXPECT_FALSE(high.onLine(1));
  EXPECT_FALSE(low.onLine(0));
  EXPECT_TRUE(low.onLine(1));
  EXPECT_EQ(high.position(), -1000);
}

TEST_F(LineSensorsTest, TimeTheDischargeOfRcSensors) {
  constexpr std::uint8_t pins[] = {2, 3, 4};
  RcLineSensors sensors(pins, 2500);
  sensors.begin();
  sensors.setRange(200, 2200);
  fake::board.pins[2].drains_us = 200;
  fake::board.pins[3].drains_us = 1200;
  fake::board.pins[4].drains_us = 9999;  // longer than the timeout
  sensors.read();
  EXPECT_NEAR(sensors.raw(0), 200, 30);
  EXPECT_NEAR(sensors.raw(1), 1200, 30);
  EXPECT_EQ(sensors.raw(2), 2500);
  EXPECT_EQ(sensors.value(2), 1000);
  EXPECT_LT(fake::board.now_us, 2600u) << "read() waits no longer than the timeout";
  EXPECT_EQ(fake::board.pins[2].level, LOW) << "a pull-up would keep the pin high";
}

TEST_F(LineSensorsTest, TimeTheDischargeWhateverTheClockSays) {
  constexpr std::uint8_t pins[] = {2};
  RcLineSensors sensors(pins, 2500);
  for (const std::uint32_t now : {0xFFF0u, 3'000'000u, 0xFFFFFF00u}) {
    fake::board.now_us = now;
    fake::board.pins[2].drains_us = 1200;
    sensors.read();
    EXPECT_NEAR(sensors.raw(0), 1200, 30) << now;
  }
}

TEST_F(LineSensorsTest, SwitchTheirLampsOn) {
  AnalogLineSensors sensors(kFive);
  sensors.setEmitterPin(7);
  sensors.begin();
  EXPECT_EQ(fake::board.pins[7].mode, OUTPUT);
  EXPECT_EQ(fake::board.pins[7].level, HIGH);
}

}  // namespace line_sensors_test
