#include "sim/exec/core/firmware_clock.h"

#include <gtest/gtest.h>

namespace robosim::exec::firmware_clock_test {

TEST(FirmwareClock, IsTheWorldsUntilItDrifts) {
  const FirmwareClock clock;
  EXPECT_EQ(clock.to_firmware(123'456'789), 123'456'789);
  EXPECT_EQ(clock.to_world(123'456'789), 123'456'789);
  EXPECT_EQ(clock.to_firmware(kNever), kNever);
}

TEST(FirmwareClock, GainsSoManyMicrosecondsASecond) {
  FirmwareClock clock;
  clock.drift(5000, 2 * kSecond);
  EXPECT_EQ(clock.to_firmware(2 * kSecond), 2 * kSecond) << "the clock does not jump";
  EXPECT_EQ(clock.to_firmware(3 * kSecond), 3 * kSecond + 5 * kMillisecond);
  EXPECT_EQ(clock.to_world(3 * kSecond + 5 * kMillisecond), 3 * kSecond);
  clock.drift(-5000, 3 * kSecond);
  EXPECT_EQ(clock.to_firmware(4 * kSecond), 4 * kSecond);
  clock.drift(0, 4 * kSecond);
  EXPECT_EQ(clock.to_firmware(9 * kSecond), 9 * kSecond);
  EXPECT_EQ(clock.to_firmware(kNever), kNever);
}

TEST(FirmwareClock, KeepsADriftsGainWhenItIsRightAgain) {
  FirmwareClock clock;
  clock.drift(1000, 0);
  clock.drift(0, kSecond);
  EXPECT_EQ(clock.to_firmware(5 * kSecond), 5 * kSecond + kMillisecond);
  EXPECT_EQ(clock.to_world(5 * kSecond + kMillisecond), 5 * kSecond);
}

TEST(FirmwareClock, IsNotSoonerThanWhatItIsTheTimeOf) {
  for (const int ppm : {-100'000, -7, 1, 333, 100'000}) {
    FirmwareClock clock;
    clock.drift(ppm, 1'000'003);
    for (SimTime world = 1'000'004; world < 1'003'000; ++world) {
      const SimTime firmware = clock.to_firmware(world);
      EXPECT_GE(clock.to_world(firmware), world) << ppm;
      EXPECT_LT(clock.to_world(firmware - 1), world) << ppm;
    }
  }
}

TEST(FirmwareClock, IsExactAfterYears) {
  FirmwareClock clock;
  clock.drift(100'000, 0);
  const SimTime year = 365 * 24 * 3600 * kSecond;
  EXPECT_EQ(clock.to_firmware(year), year / 10 * 11);
  EXPECT_EQ(clock.to_world(year / 10 * 11), year);
}

}  // namespace robosim::exec::firmware_clock_test
