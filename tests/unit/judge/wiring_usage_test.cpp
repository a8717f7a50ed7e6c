#include "sim/judge/wiring_usage.h"

#include <gmock/gmock.h>

#include "sim/exec/core/board_state.h"

namespace robosim::judge::wiring_usage_test {

using testing::ElementsAre;
using testing::IsEmpty;

class Sensor final : public PinSource {
 public:
  bool level(SimTime) override { return now > 2.5; }
  Source output(SimTime, double) override { return now; }
  double now = 0.0;
};

class UsageTest : public testing::Test {
 protected:
  result::Usage usage() { return usage_of(uno_, wiring, was_output, board, now); }
  static std::vector<std::string> told(const std::vector<result::Usage::Loose>& pins) {
    std::vector<std::string> text;
    for (const auto& pin : pins) text.push_back(pin.pin + " " + pin.how);
    return text;
  }
  static std::vector<std::string> told(const std::vector<result::Usage::Steady>& parts) {
    std::vector<std::string> text;
    for (const auto& part : parts) text.push_back(part.part + " " + part.reads);
    return text;
  }
  void set(Pin pin, PinMode mode) {
    PinDrive drive;
    drive.mode = mode;
    board.set_drive(pin, drive, 0);
    if (mode == PinMode::output) was_output[pin] = true;
  }

  const BoardSpec& uno_ = *find_board("uno");
  exec::BoardState board{uno_};
  SimTime now = 10 * kMillisecond;
  std::vector<bool> was_output = std::vector<bool>(uno_.pin_count);
  std::vector<robot::WiredPin> wiring = {{"left", "motor", "in1", 7},
                                         {"left", "motor", "in2", 8},
                                         {"start", "button", "", 4},
                                         {"S", "reflectance-array", "S1", 14},
                                         {"S", "reflectance-array", "S2", 15}};
};

TEST_F(UsageTest, ATimerThatListensToItsUnwiredCaptureInputDoesNotMeanThatTheSketchReadsIt) {
  wiring.clear();
  board.set_wants_edges(8, true, 0);  // ICP1, the capture input
  board.set_wants_edges(9, true, 0);  // a pin-change interrupt
  EXPECT_THAT(told(usage().unwired), ElementsAre("D9 read"));
  board.read_level(8, 0);
  EXPECT_THAT(told(usage().unwired), ElementsAre("D8 read", "D9 read"));

  const BoardSpec& mega = *find_board("mega");
  exec::BoardState with_registers_of_uno{mega};
  with_registers_of_uno.set_wants_edges(8, true, 0);
  EXPECT_THAT(
      told(usage_of(mega, wiring, std::vector<bool>(mega.pin_count), with_registers_of_uno, now).unwired),
      testing::IsEmpty());
}

TEST_F(UsageTest, AnUnwiredCaptureInputWithAPullUpOrAsAnOutputIsNamed) {
  wiring.clear();
  board.set_wants_edges(8, true, 0);
  set(8, PinMode::input_pullup);
  board.read_level(8, 0, ReadIntent::port);
  EXPECT_THAT(told(usage().unwired), ElementsAre("D8 read"));
  set(8, PinMode::output);
  EXPECT_THAT(told(usage().unwired), ElementsAre("D8 driven"));
}

TEST_F(UsageTest, WhatASketchNeverTouchesIsUnusedByElementAndByPart) {
  EXPECT_THAT(usage().unused, ElementsAre("left", "start", "S1", "S2"));
  board.read_level(7, 0, ReadIntent::port);  // read together with other pins of its port
  EXPECT_THAT(usage().unused, ElementsAre("left", "start", "S1", "S2"));
  set(8, PinMode::output);
  board.read_volts(15, 0);
  board.set_wants_edges(4, true, 0);
  EXPECT_THAT(usage().unused, ElementsAre("S1"));
}

TEST_F(UsageTest, PinsThatAreUsedWithNothingWiredToThemAreNamed) {
  EXPECT_THAT(usage().unwired, IsEmpty());
  set(6, PinMode::output);
  set(13, PinMode::output);  // the LED on the board
  set(7, PinMode::output);   // the robot's motor
  set(2, PinMode::input_pullup);
  board.read_level(2, kMillisecond);
  board.read_volts(16, kMillisecond);
  EXPECT_THAT(told(usage().unwired), ElementsAre("D2 read", "D6 driven", "A2 read"));
}

TEST_F(UsageTest, APinThatIsReadWithItsWholePortIsNotBlamed) {
  for (int pass = 0; pass < 3; ++pass)
    for (Pin pin = 0; pin < 8; ++pin) board.read_level(pin, pass * kMillisecond, ReadIntent::port);
  EXPECT_THAT(usage().unwired, IsEmpty());
}

TEST_F(UsageTest, PinsThatAreLookedAtInOneReadAreAllNamedAndSoIsOneThatIsReadOnce) {
  for (const Pin pin : {2, 3}) board.read_level(pin, kMillisecond);  // as PIND & 0x0C does
  board.read_level(5, kSecond);
  EXPECT_THAT(told(usage().unwired), ElementsAre("D2 read", "D3 read", "D5 read"));
}

TEST_F(UsageTest, AnInputThatGaveTheSameThroughoutIsSteadyAndOneThatChangedIsNot) {
  Sensor s1;
  Sensor s2;
  board.connect(14, s1);
  board.connect(15, s2);
  board.read_level(4, 0);
  for (int i = 0; i < 5; ++i) {
    s1.now = 4.3 + 0.01 * i;  // simulates noise
    s2.now = 0.5 * i;
    board.read_volts(14, i * kMillisecond);
    board.read_volts(15, i * kMillisecond);
  }
  EXPECT_THAT(told(usage().steady), ElementsAre("start LOW", "S1 4.3 V"));
}

TEST_F(UsageTest, AnInputThatTheSketchStoppedReadingIsSteadyWithTheTimeOfTheLastRead) {
  Sensor s1;
  board.connect(14, s1);
  board.read_level(4, 20 * kMillisecond);
  board.read_volts(14, kSecond);
  now = 2 * kSecond;
  EXPECT_THAT(told(usage().steady),
              ElementsAre("start LOW, last read at 0.02 s", "S1 0.0 V, last read at 1.00 s"));
  now -= kMillisecond;
  EXPECT_THAT(told(usage().steady), ElementsAre("start LOW, last read at 0.02 s", "S1 0.0 V"));
}

}  // namespace robosim::judge::wiring_usage_test
