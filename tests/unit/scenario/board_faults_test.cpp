// Tests faults of the connections between a board and the simulated world. The tests act as the firmware.
#include "sim/run/scenario/board_faults.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "sim/exec/core/board_state.h"
#include "sim/map/map.h"
#include "sim/robot/describe.h"
#include "sim/robot/description.h"
#include "sim/world/world.h"
#include "tests/support/fake_firmware.h"
#include "tests/support/refusal.h"

namespace robosim::scenario::board_faults_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr SimTime ms = kMillisecond;

/// An executor that records calls.
class Probe final : public test::FakeFirmware {
 public:
  void power_on(SimTime t) override {
    state.reset(t);
    state.listen(1, t);
    power.push_back(t / ms);
  }
  void power_recovered(SimTime t) override {
    power_on(t);
    ++recovered;
  }
  void power_off(SimTime t) override {
    state.reset(t);
    power.push_back(-t / ms);
  }
  bool has_boards_eeprom() const override { return reaches_eeprom; }
  void set_clock_drift(int ppm, SimTime) override { drift = ppm; }

  std::string received() {
    std::string text;
    for (exec::BoardInput input; state.take_input(kSecond, input);) text += static_cast<char>(input.value);
    return text;
  }

  exec::BoardState& state = board_;
  std::vector<SimTime> power;  // times in ms: positive for power on, negative for power off
  int recovered = 0;
  bool reaches_eeprom = true;
  int drift = 0;
};

class BoardFaultsTest : public testing::Test {
 protected:
  BoardFaultsTest() { probe.state.listen(1, 0); }

  void fail(std::vector<std::string> words, SimTime t = 0) {
    const std::string name = words.front();
    words.erase(words.begin());
    faults.fail(faults.read(name, words), t);
  }
  std::string refusal(std::vector<std::string> words, bool ends = false) {
    const std::string name = words.front();
    words.erase(words.begin());
    return test::refusal([&] { faults.read(name, words, ends); });
  }

  map::Map map = map::read_map(map::find_map("oval"));
  world::World world{map};
  robot::Description description = robot::load_description("uno5");
  Probe probe;
  robot::Robot robot{
      description,
      world,
      world.add_body(robot::body_params(description, 1, robot::Profile::ideal), {{0.5, 0.5}, {1, 0}}),
      probe.state,
      1,
      robot::Profile::ideal};
  BoardFaults faults{probe, robot, 1};
};

TEST_F(BoardFaultsTest, ASagOfTheBatteryResetsTheChipBelowItsBrownOutVoltage) {
  EXPECT_EQ(robot.battery(), 7.4);
  fail({"power", "sag", "4.6V"}, 10 * ms);
  EXPECT_TRUE(faults.powered()) << "2.8 V are left for the chip";
  fail({"power", "sag", "4.4V"}, 20 * ms);
  EXPECT_FALSE(faults.powered());
  fail({"power", "ok"}, 30 * ms);
  EXPECT_TRUE(faults.powered());
  EXPECT_THAT(probe.power, ElementsAre(-20, 30));
  EXPECT_EQ(faults.boots(), 2u);
}

TEST_F(BoardFaultsTest, ABrownOutResetsTheChip) {
  fail({"power", "brown-out"}, 10 * ms);
  EXPECT_FALSE(faults.powered());
  fail({"power", "ok"}, 15 * ms);
  EXPECT_THAT(probe.power, ElementsAre(-10, 15));
}

TEST_F(BoardFaultsTest, ASupplyThatWasGoneIsNoBrownOut) {
  fail({"power", "sag", "4V"}, 10 * ms);
  fail({"power", "ok"}, 20 * ms);
  EXPECT_EQ(probe.recovered, 1);
  fail({"power", "sag", "2V"}, 30 * ms);
  fail({"power", "sag", "4V"}, 35 * ms);
  fail({"power", "ok"}, 40 * ms);
  faults.switch_power(false, 50 * ms);
  faults.switch_power(true, 60 * ms);
  EXPECT_EQ(probe.recovered, 1);
  fail({"power", "brown-out"}, 70 * ms);
  fail({"power", "ok"}, 80 * ms);
  EXPECT_EQ(probe.recovered, 2);
  EXPECT_EQ(faults.boots(), 5u);
}

TEST_F(BoardFaultsTest, ASagMovesNothingThatTheSwitchHasTurnedOff) {
  faults.switch_power(false, 10 * ms);
  fail({"power", "sag", "3V"}, 20 * ms);
  faults.switch_power(true, 30 * ms);
  EXPECT_FALSE(faults.powered()) << "the switch is on, but the voltage is too low";
  fail({"power", "ok"}, 40 * ms);
  EXPECT_THAT(probe.power, ElementsAre(-10, 40));
}

TEST_F(BoardFaultsTest, AByteIsBeingWrittenFor3400Microseconds) {
  EXPECT_FALSE(faults.leave_half_written({HalfWritten::Kind::value, 0}, 0));
  probe.state.write_eeprom(12, 0x5A, 10 * ms);
  probe.state.write_eeprom(12, 0x33, 20 * ms);
  EXPECT_EQ(faults.eeprom_writes(), 2u);
  const auto byte = faults.leave_half_written({HalfWritten::Kind::before}, 21 * ms);
  ASSERT_TRUE(byte);
  EXPECT_EQ(byte->address, 12);
  EXPECT_EQ(byte->value, 0x5A);
  EXPECT_EQ(probe.state.memory()[12], 0x5A);
  faults.leave_half_written({HalfWritten::Kind::value, 0x77}, 23 * ms);
  EXPECT_EQ(probe.state.memory()[12], 0x77);
  EXPECT_FALSE(faults.leave_half_written({HalfWritten::Kind::value, 0}, 24 * ms)) << "the write was complete";
  EXPECT_EQ(probe.state.memory()[12], 0x77);
}

TEST_F(BoardFaultsTest, AFlippedBitIsTheOtherOneFromThenOn) {
  probe.state.memory()[0x3FF] = 0b1010'0000;
  fail({"eeprom", "flip", "0x3FF", "7"});
  fail({"eeprom", "flip", "1023", "0"});
  EXPECT_EQ(probe.state.memory()[0x3FF], 0b0010'0001);
}

TEST_F(BoardFaultsTest, AUsedEepromHoldsSomethingElseEverywhereByTheSeed) {
  std::uint8_t* const bytes = probe.state.memory().data();
  const auto used = [&](std::uint64_t seed) {
    std::fill_n(bytes, 1024, std::uint8_t{0xFF});
    BoardFaults others(probe, robot, seed);
    others.fail(others.read("eeprom", {"used"}), 0);
    return std::vector<std::uint8_t>(bytes, bytes + 1024);
  };
  const std::vector<std::uint8_t> first = used(1);
  EXPECT_EQ(used(1), first);
  EXPECT_NE(used(2), first);
  EXPECT_GT(std::set<std::uint8_t>(first.begin(), first.end()).size(), 200u);
}

TEST_F(BoardFaultsTest, BytesToTheFirmwareAreLostDoubledOrCorrupted) {
  faults.send("ab", 0);
  fail({"serial", "lost", "2nd"});
  faults.send("cde", 0);
  fail({"serial", "doubled", "100%"});
  faults.send("fg", 0);
  fail({"serial", "ok"});
  faults.send("h", 0);
  EXPECT_EQ(probe.received(), "abceffggh");
  fail({"serial", "corrupted", "1st"});
  faults.send("AB", 0);
  const std::string received = probe.received();
  ASSERT_THAT(received, SizeIs(2));
  EXPECT_EQ(__builtin_popcount(static_cast<unsigned char>(received[0] ^ 'A')), 1) << "one bit";
  EXPECT_EQ(received[1], 'B');
}

TEST_F(BoardFaultsTest, ARateOfLossIsMetAndIsTheSameInEveryRun) {
  fail({"serial", "lost", "30%"});
  faults.send(std::string(1000, 'x'), 0);
  const std::size_t first = probe.received().size();
  EXPECT_NEAR(static_cast<double>(first), 700.0, 45.0);  // a tolerance of three standard deviations
  Probe other;
  other.state.listen(1, 0);
  BoardFaults again(other, robot, 1);
  again.fail(again.read("serial", {"lost", "30%"}), 0);
  again.send(std::string(1000, 'x'), 0);
  EXPECT_EQ(other.received().size(), first);
}

TEST_F(BoardFaultsTest, TheClockRunsFastOrSlow) {
  fail({"clock", "drift", "-5000ppm"});
  EXPECT_EQ(probe.drift, -5000);
  fail({"clock", "drift", "0.5%"});
  EXPECT_EQ(probe.drift, 5000);
  fail({"clock", "ok"});
  EXPECT_EQ(probe.drift, 0);
}

TEST_F(BoardFaultsTest, WhatIsNoFaultIsRefusedWithWhatThereIs) {
  EXPECT_EQ(refusal({"power", "surge"}),
            "unknown fault of power: expected ok, sag or brown-out, got “surge”");
  EXPECT_EQ(refusal({"power", "sag"}), "fault power sag: expected a voltage after it");
  EXPECT_THAT(refusal({"power", "sag", "low"}), HasSubstr("expected the battery's voltage from 0V to 60V"));
  EXPECT_THAT(refusal({"serial", "lost", "2"}), HasSubstr("expected a share of the bytes"));
  EXPECT_THAT(refusal({"serial", "lost", "0th"}), HasSubstr("expected a share of the bytes"));
  EXPECT_THAT(refusal({"eeprom", "flip", "1024", "0"}),
              HasSubstr("an address from 0 to 1023 and a bit from 0 to 7"));
  EXPECT_THAT(refusal({"eeprom", "flip", "3", "8"}), HasSubstr("a bit from 0 to 7"));
  EXPECT_EQ(refusal({"eeprom", "flip", "3"}), "fault eeprom flip: expected an address and a bit after it");
  EXPECT_EQ(refusal({"eeprom", "used", "3"}), "fault eeprom used: expected nothing after it");
  EXPECT_THAT(refusal({"eeprom", "flip", "3", "1"}, true),
              HasSubstr("happens once and cannot end after a time"));
  EXPECT_THAT(refusal({"clock", "drift", "200000ppm"}), HasSubstr("from -100000ppm to 100000ppm"));
  EXPECT_THAT(refusal({"clock", "drift", "fast"}),
              HasSubstr("expected the amount by which the clock is too fast"));
  EXPECT_EQ(refusal({"serial", "lost", "5%"}, true), "accepted");
  probe.reaches_eeprom = false;
  EXPECT_EQ(refusal({"clock", "drift", "5ppm"}), "accepted");
  EXPECT_THAT(refusal({"eeprom", "flip", "3", "1"}),
              HasSubstr("eeprom: scripts can neither damage the EEPROM nor await its writes on this target"));
  EXPECT_THAT(probe.power, IsEmpty());
}

}  // namespace robosim::scenario::board_faults_test
