// Tests the detectors of EEPROM bugs: wear, records that a power cut can tear, and records whose bytes were
// all written to one address.
#include <gmock/gmock.h>

#include <map>

#include "sim/detect/eeprom_wear.h"
#include "sim/detect/overwritten_record.h"
#include "sim/detect/torn_record.h"
#include "sim/exec/core/board_state.h"
#include "tests/support/fake_firmware.h"

namespace robosim::detect::eeprom_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// An executor that does nothing, but reports the source line `line`, which the test sets.
struct Told final : test::FakeFirmware {
  exec::SourceLine source() override { return {"loop", "My.ino", line}; }
  int line = 1;
};

class EepromTest : public testing::Test {
 protected:
  /// Writes a byte as EEPROM.write() does: first waits until the previous byte is written.
  void write(std::uint16_t address, std::uint8_t value) {
    std::uint8_t& cell = cells_.try_emplace(address, 0xFF).first->second;
    now = std::max(now, ready_);
    wear.eeprom_written(address, cell, value, now);
    record.eeprom_written(address, cell, value, now);
    overwritten.eeprom_written(address, cell, value, now);
    cell = value;
    ready_ = now + kEepromWriteTime;
  }
  void update(std::uint16_t address, std::uint8_t value) {
    if (cells_.try_emplace(address, 0xFF).first->second != value) write(address, value);
  }
  /// Writes an int as EEPROM.put() does.
  void put(std::uint16_t address, int value) {
    update(address, static_cast<std::uint8_t>(value));
    update(static_cast<std::uint16_t>(address + 1), static_cast<std::uint8_t>(value >> 8));
  }
  void count(int from, int to) {
    for (int n = from; n <= to; ++n, now += kSecond) put(0, n);
  }

  Told sketch;
  SnapshotRegistry snapshots;
  EepromWear wear{sketch, snapshots};
  TornRecord record{sketch, snapshots};
  OverwrittenRecord overwritten{sketch, snapshots};
  SimTime now = 0;

 private:
  std::map<std::uint16_t, std::uint8_t> cells_;
  SimTime ready_ = 0;
};

TEST_F(EepromTest, AByteWrittenInEachPassIsUsedUpInHoursWhichIsSaidWithTheLine) {
  sketch.line = 12;
  for (int i = 0; i < 61; ++i, now += kSecond / 10) write(7, static_cast<std::uint8_t>(i));
  const auto found = wear.found(now);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].where.line, 12);
  EXPECT_EQ(found[0].times, 61);
  EXPECT_DOUBLE_EQ(found[0].first_s, 5.0);
  EXPECT_EQ(found[0].what,
            "byte 7 of the EEPROM withstands 100,000 writes, or 2.8 hours of driving at this rate: it was "
            "written 61 times in 6.0 s");
  EXPECT_THAT(found[0].mend, HasSubstr("not in each pass of loop()"));
}

TEST_F(EepromTest, WritesOfWhatWasThereAlreadyAreFoundSoonerAndMendedByUpdate) {
  for (int i = 0; i < 11; ++i, now += kSecond / 5) write(7, 3);
  const auto found = wear.found(now);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(found[0].what, HasSubstr("11 times in 2.0 s, 10 of them with the value that it held"));
  EXPECT_THAT(found[0].mend, HasSubstr("EEPROM.update()"));
}

TEST_F(EepromTest, SavingOnceSeldomOrByTurnsWearsNothing) {
  for (std::uint16_t i = 0; i < 64; ++i) write(i, 1);                                        // once
  for (int i = 0; i < 30; ++i, now += 2 * kSecond) update(0, static_cast<std::uint8_t>(i));  // rarely
  for (std::uint16_t i = 0; i < 300; ++i, now += kSecond / 10) write(100 + i % 100, 1);      // alternately
  for (int i = 0; i < 30; ++i) write(500, static_cast<std::uint8_t>(i));                     // a burst
  EXPECT_THAT(wear.found(now), IsEmpty());
}

TEST_F(EepromTest, ARecordWhoseBytesAllGoToOneAddressIsLost) {
  sketch.line = 40;
  for (int i = 0; i < 30; ++i) write(0, static_cast<std::uint8_t>(3 * i));
  for (int i = 0; i < 3; ++i) write(1, static_cast<std::uint8_t>(i));
  const auto found = overwritten.found(now);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].detector, "overwritten_record");
  EXPECT_EQ(found[0].where.line, 40);
  EXPECT_THAT(found[0].what, HasSubstr("byte 0 of the EEPROM was written 30 times in immediate succession"));
}

TEST_F(EepromTest, ARecordIsStoredWhereItsAddressIsCountedOnOrTheSameByteIsKeptUpToDate) {
  for (std::uint16_t i = 0; i < 64; ++i) write(i, static_cast<std::uint8_t>(i));              // ascending
  for (int i = 0; i < 30; ++i) write(i % 2, static_cast<std::uint8_t>(i));                    // alternately
  for (int i = 0; i < 30; ++i, now += kSecond / 100) write(7, static_cast<std::uint8_t>(i));  // with pauses
  for (int i = 0; i < 2000; ++i) write(9, static_cast<std::uint8_t>(i));                      // takes 6.8 s
  EXPECT_THAT(overwritten.found(now), IsEmpty());
}

TEST_F(EepromTest, OfEachPowerCycleItIsCountedAnew) {
  for (int boot = 0; boot < 30; ++boot, now += kSecond / 2) {
    wear.powered_on();
    write(0, static_cast<std::uint8_t>(boot));
  }
  EXPECT_THAT(wear.found(now), IsEmpty());
}

TEST_F(EepromTest, ANumberOfTwoBytesCanBeTornWhereBothChange) {
  sketch.line = 5;
  count(250, 260);
  const auto found = record.found(now);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].detector, "torn_record");
  EXPECT_EQ(found[0].where.line, 5);
  EXPECT_EQ(found[0].times, 1);
  EXPECT_THAT(found[0].what,
              HasSubstr("a power cut from 6.0034 to 6.0102 s (in a script: “after eeprom 8 "
                        "power off for 20ms”) leaves 00 00 in bytes 0 to 1 of the EEPROM, neither "
                        "the old FF 00 nor the new 00 01"));
  EXPECT_THAT(found[0].mend, HasSubstr("checksum"));
}

TEST_F(EepromTest, NothingIsTornThatOneByteHoldsOrThatIsSavedOnce) {
  count(1, 250);
  put(10, 1000);
  EXPECT_THAT(record.found(now), IsEmpty());
}

TEST_F(EepromTest, ANumberWithAChecksumOrAMarkIsNotTorn) {
  for (int n = 250; n < 260; ++n, now += kSecond) {
    sketch.line = 3;
    put(0, n);
    sketch.line = 4;
    update(2, static_cast<std::uint8_t>(n * 7));
  }
  sketch.line = 5;
  for (int n = 0; n < 20; ++n, now += kSecond) put(10, n % 256 | (~n & 0xFF) << 8);  // bytes n, ~n
  EXPECT_THAT(record.found(now), IsEmpty());
}

}  // namespace robosim::detect::eeprom_test
