// Tests the backup domain (RM0008, chapters 5, 6 and 18, and section 7.3.9). Also tests the CRC unit (chapter
// 4) and the cycle counter.
#include "tests/unit/exec_stm32/bus_fixture.h"

namespace robosim::exec::stm32::backup_test {

using namespace robosim::stm32;

constexpr Cycle kMs = 8000;
constexpr std::uint32_t kCnf = 1u << 4;

class BackupTest : public BusFixture {
 protected:
  void SetUp() override {
    BusFixture::SetUp();
    store(kPwr, 1u << 8);
  }
  /// Starts the RTC, which counts hundredths of a second. Its clock is LSI.
  void start_rtc() {
    store(kRccCsr, kLsiOn);
    store(kRccBdcr, 1u << 15 | 2u << 8);
    store(kRtc + 4, kCnf);
    store(kRtc + 12, 399);
    store(kRtc + 8, 0);
    store(kRtc + 0x1C, 0);
    store(kRtc + 0x18, 0);
    store(kRtc + 4, 0);
  }
  std::uint32_t counter() { return load(kRtc + 0x18) << 16 | load(kRtc + 0x1C); }
};

TEST_F(BackupTest, RegistersKeepTheirContentOverAResetAndAreProtected) {
  store(kBkp + 4, 0x1234);
  store(kPwr, 0);
  store(kBkp + 4, 0x5678);
  EXPECT_EQ(load(kBkp + 4), 0x1234u);
  store(kRccBdcr, 1);
  EXPECT_EQ(load(kRccBdcr), 0u);
  bus_.link().reset_cause = Reset::software;
  bus_.reset();
  SetUp();
  EXPECT_EQ(load(kBkp + 4), 0x1234u);
  store(kRccBdcr, 1u << 16);
  EXPECT_EQ(load(kBkp + 4), 0u);
}

TEST_F(BackupTest, TheCrystalStartsSlowly) {
  store(kRccBdcr, 1);
  pass(2499 * kMs);
  EXPECT_EQ(load(kRccBdcr), 1u);
  pass(1 * kMs);
  EXPECT_EQ(load(kRccBdcr), 3u);
}

TEST_F(BackupTest, TheClockCountsInterruptsAndGoesOnThroughAReset) {
  start_rtc();
  enable(kIrqRtc);
  EXPECT_EQ(load(kRtc + 4), 0x28u) << "RTOFF and RSF";
  pass(10 * kMs - 1);
  EXPECT_EQ(counter(), 0u);
  EXPECT_EQ(load(kRtc + 0x14), 0u);
  pass(1);
  EXPECT_EQ(counter(), 1u);
  EXPECT_EQ(load(kRtc + 0x14), 399u);
  store(kRtc, 1);
  EXPECT_TRUE(takes(kIrqRtc)) << "the flag of this interrupt was set";
  store(kRtc + 4, 0);
  EXPECT_FALSE(takes(kIrqRtc));
  pass(10 * kMs);
  EXPECT_TRUE(takes(kIrqRtc));
  store(kRtc + 0x1C, 77);
  EXPECT_EQ(counter(), 2u) << "the counter can be written only while CNF is set";
  store(kRccBdcr, 1u << 15 | 3u << 8 | 1);
  store(kRccCr, load(kRccCr) | kHseOn);
  pass(kMs);
  EXPECT_EQ(counter(), 2u);
}

TEST_F(BackupTest, TheAlarmComesByExtisLine17) {
  start_rtc();
  enable(kIrqRtcAlarm);
  store(kRtc + 4, kCnf);
  store(kRtc + 0x20, 0);
  store(kRtc + 0x24, 5);
  store(kRtc + 4, 0);
  store(kExtiImr, 1u << 17);
  store(kExtiRtsr, 1u << 17);
  pass(50 * kMs - 1);
  EXPECT_FALSE(takes(kIrqRtcAlarm));
  pass(1);
  EXPECT_EQ(load(kRtc + 4) & 3, 3u);
  EXPECT_EQ(load(kExtiPr), 1u << 17);
  store(kExtiPr, 1u << 17);
  EXPECT_TRUE(takes(kIrqRtcAlarm));
}

TEST_F(BackupTest, TheCrcUnitGivesWhatTheManualsPolynomialDoes) {
  store(kCrc + 8, 1);
  store(kCrc, 0x12345678);
  EXPECT_EQ(load(kCrc), 0xDF8A8A2Bu);
  store(kCrc + 4, 0xAB);
  store(kCrc + 8, 1);
  EXPECT_EQ(load(kCrc), 0xFFFFFFFFu);
  EXPECT_EQ(load(kCrc + 4), 0xABu);
}

TEST_F(BackupTest, TheCycleCounterCountsWhileItIsEnabled) {
  store(0xE000EDFC, 1u << 24);
  store(0xE0001004, 0);
  store(0xE0001000, 1);
  pass(1234);
  EXPECT_EQ(load(0xE0001004), 1234u);
  store(0xE0001000, 0);
  pass(10);
  EXPECT_EQ(load(0xE0001004), 1234u);
  EXPECT_EQ(load(0xE0042000) & 0xFFF, 0x410u) << "a medium-density device";
}

}  // namespace robosim::exec::stm32::backup_test
