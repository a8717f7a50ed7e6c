// Tests the watchdogs (RM0008, chapters 19 and 20), and the causes of resets in RCC_CSR (7.3.10).
#include "tests/unit/exec_stm32/bus_fixture.h"

namespace robosim::exec::stm32::watchdogs_test {

using namespace robosim::stm32;

constexpr Cycle kMs = 8000;  // cycles of the 8 MHz clock HSI

class WatchdogsTest : public BusFixture {
 protected:
  Reset cause() { return bus_.link().reset_cause; }
};

TEST_F(WatchdogsTest, TheIndependentOneResetsBehindItsTimeUnlessItIsReloaded) {
  store(kIwdg + 4, 3);
  EXPECT_EQ(load(kIwdg + 4), 0u) << "the register is locked";
  store(kIwdg, 0xCCCC);
  store(kIwdg, 0x5555);
  store(kIwdg + 4, 3);    // a count takes 32 / 40 kHz = 0.8 ms
  store(kIwdg + 8, 124);  // 125 counts, which is 100 ms
  EXPECT_EQ(load(kIwdg + 12), 0u);
  store(kIwdg, 0xAAAA);
  pass(99 * kMs);
  store(kIwdg, 0xAAAA);
  pass(100 * kMs - 1);
  EXPECT_EQ(cause(), Reset::none);
  pass(1);
  EXPECT_EQ(cause(), Reset::independent_watchdog);
}

TEST_F(WatchdogsTest, TheIndependentOneTakesItsOwnTimeWhateverTheProcessorsClock) {
  store(kIwdg, 0xCCCC);  // the default timeout is 4 * 4096 / 40 kHz = 409.6 ms
  pass(kMs);
  store(kRccCr, kHsiOn | kPllOn);
  store(kRccCfgr, kPllMul9 | kSwPll);  // 36 MHz
  pass(36 * 4086 * kMs / 80 - 1);
  EXPECT_EQ(cause(), Reset::none);
  pass(1);
  EXPECT_EQ(cause(), Reset::independent_watchdog);
}

TEST_F(WatchdogsTest, TheWindowWatchdogResetsWhenItIsWrittenTooLateOrTooEarly) {
  store(kWwdg + 4, 0x50 | 1u << 7);  // sets the window; a count takes 8192 cycles
  store(kWwdg, 0xFF);
  pass(0x2E * 8192);
  EXPECT_EQ(load(kWwdg), 0xD1u);
  store(kWwdg, 0xFF);
  EXPECT_EQ(cause(), Reset::window_watchdog) << "0x51 is above the window";
  bus_.reset();
  SetUp();
  store(kWwdg + 4, 0x50);
  store(kWwdg, 0xFF);
  pass(0x2F * 4096);
  store(kWwdg, 0xC1);
  pass(2 * 4096 - 1);
  EXPECT_EQ(cause(), Reset::none);
  pass(1);
  EXPECT_EQ(cause(), Reset::window_watchdog);
}

TEST_F(WatchdogsTest, TheWindowWatchdogInterruptsAStepBeforeItsEnd) {
  enable(kIrqWwdg);
  store(kWwdg + 4, 0x7F | 1u << 9);
  store(kWwdg, 0xC3);
  pass(3 * 4096 - 1);
  EXPECT_FALSE(takes(kIrqWwdg));
  pass(1);
  EXPECT_EQ(load(kWwdg + 8), 1u);
  store(kWwdg + 8, 0);
  EXPECT_TRUE(takes(kIrqWwdg));
  store(kWwdg, 0xFF);
  pass(4096);
  EXPECT_EQ(cause(), Reset::none);
}

TEST_F(WatchdogsTest, TheFlagsOfResetsAddUpUntilTheyAreRemoved) {
  EXPECT_EQ(load(kRccCsr), kPowerOnReset | kPinReset);
  store(kRccCsr, kRemoveFlags | kLsiOn);
  EXPECT_EQ(load(kRccCsr), kLsiOn | kLsiReady);
  store(kScbAircr, 0x05FA0004);
  EXPECT_EQ(cause(), Reset::software);
  EXPECT_EQ(bus_.next_event(), 0u) << "the processor stops for the reset";
  bus_.reset();
  EXPECT_EQ(cause(), Reset::none);
  EXPECT_EQ(load(kRccCsr), kSoftwareReset | kPinReset);
  EXPECT_EQ(load(kRccApb2Enr), 0u);
  store(kIwdg, 0xCCCC);
  pass(410 * kMs);
  bus_.reset();
  EXPECT_EQ(load(kRccCsr), kIwdgReset | kSoftwareReset | kPinReset);
  pass(1000 * kMs);
  EXPECT_EQ(cause(), Reset::none) << "the watchdog is off after a reset";
}

}  // namespace robosim::exec::stm32::watchdogs_test
