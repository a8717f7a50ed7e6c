#include "sim/exec/core/board_state.h"

#include "tests/unit/exec/fixture.h"

namespace robosim::exec::board_state_test {

using testing::ElementsAre;

PinDrive output(bool level) {
  PinDrive drive;
  drive.mode = PinMode::output;
  drive.level = level;
  drive.duty = level ? 1.0 : 0.0;
  return drive;
}

PinDrive pull_up() {
  PinDrive drive;
  drive.mode = PinMode::input_pullup;
  return drive;
}

class BoardStateTest : public testing::Test {
 protected:
  /// Returns all inputs up to `until`, in order. An edge is returned as its pin number, and a received byte
  /// as 100 + its value.
  std::vector<int> inputs(SimTime until) {
    std::vector<int> result;
    BoardInput input;
    while (board_.take_input(until, input))
      result.push_back(input.kind == BoardInput::Kind::edge ? input.pin : 100 + input.value);
    return result;
  }

  BoardState board_{*find_board("uno")};
};

TEST_F(BoardStateTest, AnUnconnectedPinReadsHighWithAPullUpAndLowWithout) {
  EXPECT_FALSE(board_.read_level(2, 0));
  board_.set_drive(2, pull_up(), 0);
  EXPECT_TRUE(board_.read_level(2, 0));
  EXPECT_EQ(board_.read_volts(2, 0), 5.0);
}

TEST_F(BoardStateTest, AConnectedPinReadsItsSourceAtTheTimeAskedFor) {
  FixedSource source(3.3);
  board_.connect(14, source);
  EXPECT_EQ(board_.read_volts(14, 42), 3.3);
  EXPECT_EQ(source.asked_at.back(), 42);
  EXPECT_TRUE(board_.read_level(14, 43));
  EXPECT_EQ(source.asked_at.back(), 43);
}

TEST_F(BoardStateTest, AnOutputReadsBackItsOwnLevelWhateverIsConnected) {
  FixedSource source(5.0);
  board_.connect(7, source);
  board_.set_drive(7, output(false), 0);
  EXPECT_FALSE(board_.read_level(7, 0));
  board_.set_drive(7, output(true), 0);
  EXPECT_TRUE(board_.read_level(7, 0));
}

TEST_F(BoardStateTest, OnlyChangesAreReportedToWatchersInTheOrderOfRegistration) {
  struct Watcher : PinWatcher {
    Watcher(std::vector<int>& log, int name) : log_(log), name_(name) {}
    void pin_changed(Pin, const PinDrive&, SimTime) override { log_.push_back(name_); }
    std::vector<int>& log_;
    int name_;
  };
  std::vector<int> log;
  Watcher first(log, 1), second(log, 2);
  board_.watch(5, first);
  board_.watch(5, second);
  board_.set_drive(5, output(true), 0);
  board_.set_drive(5, output(true), 10);
  board_.set_drive(6, output(true), 20);
  EXPECT_THAT(log, ElementsAre(1, 2));
}

TEST_F(BoardStateTest, EdgesArriveInTheOrderOfTimeWhateverPinTheyAreOn) {
  board_.set_wants_edges(2, true, 0);
  board_.set_wants_edges(3, true, 0);
  board_.schedule_edge(2, true, 300);
  board_.schedule_edge(3, true, 100);
  board_.schedule_edge(3, false, 400);
  EXPECT_EQ(board_.next_input(), 100);
  EXPECT_THAT(inputs(300), ElementsAre(3, 2));
  EXPECT_EQ(board_.next_input(), 400);
}

TEST_F(BoardStateTest, EdgesThatNobodyWantsAreNoInput) {
  board_.schedule_edge(2, true, 100);
  EXPECT_EQ(board_.next_input(), kNever);
  EXPECT_FALSE(board_.wants_edges(2));
  board_.set_wants_edges(2, true, 50);
  EXPECT_TRUE(board_.wants_edges(2));
  EXPECT_EQ(board_.next_input(), 100);
}

TEST_F(BoardStateTest, NoEdgeLeadsToTheLevelThatAPinHasAlready) {
  FixedSource high(5.0);
  board_.connect(2, high);
  EXPECT_TRUE(board_.set_wants_edges(2, true, 100));
  board_.schedule_edge(2, true, 200);
  board_.schedule_edge(2, false, 300);
  board_.schedule_edge(2, false, 400);
  board_.schedule_edge(2, true, 500);
  EXPECT_EQ(board_.next_input(), 300);
  EXPECT_THAT(inputs(kSecond), ElementsAre(2, 2));
}

TEST_F(BoardStateTest, ARequestForEdgesDropsEarlierEdgesAndEdgesWithoutAChange) {
  board_.schedule_edge(2, true, 100);
  board_.schedule_edge(2, false, 300);
  board_.schedule_edge(2, true, 400);
  EXPECT_FALSE(board_.set_wants_edges(2, true, 200));
  EXPECT_EQ(board_.next_input(), 400);
  EXPECT_THAT(inputs(kSecond), ElementsAre(2));
}

TEST_F(BoardStateTest, TheNextEdgeIsComparedWithTheLevelThatThePinDroveAsAnOutput) {
  board_.set_wants_edges(2, true, 0);
  board_.set_drive(2, output(true), 10);
  board_.set_drive(2, PinDrive{}, 20);
  board_.schedule_edge(2, false, 30);
  EXPECT_THAT(inputs(kSecond), ElementsAre(2));
}

TEST_F(BoardStateTest, BytesArriveOneAfterTheOtherAtTheBaudRate) {
  board_.listen(1000, 0);
  board_.receive_byte(1, 500);
  board_.receive_byte(2, 500);
  board_.receive_byte(3, 10000);
  EXPECT_EQ(board_.next_input(), 1500);
  EXPECT_THAT(inputs(1500), ElementsAre(101));
  EXPECT_EQ(board_.next_input(), 2500);
  EXPECT_THAT(inputs(2500), ElementsAre(102));
  EXPECT_EQ(board_.next_input(), 11000);
}

TEST_F(BoardStateTest, BytesSentBeforeTheReceiverListensAreLost) {
  board_.receive_byte(1, 500);
  board_.receive_byte(2, 2000);
  board_.listen(1000, 1000);
  EXPECT_THAT(inputs(kSecond), ElementsAre(102));
}

TEST_F(BoardStateTest, AResetFreesPinsAndForgetsWhatIsOnItsWayButNotTheEeprom) {
  board_.set_drive(9, output(true), 0);
  board_.set_wants_edges(2, true, 0);
  board_.schedule_edge(2, true, 100);
  board_.write_eeprom(7, 42, 0);
  board_.reset(50);
  EXPECT_EQ(board_.drive(9), PinDrive{});
  EXPECT_EQ(board_.next_input(), kNever);
  EXPECT_EQ(board_.read_eeprom(7), 42);
  EXPECT_EQ(board_.read_eeprom(8), 0xFF);
}

TEST_F(BoardStateTest, ReportsEachEepromWriteWithThePreviousValue) {
  struct Watcher final : EepromWatcher {
    void eeprom_written(std::uint16_t address, std::uint8_t before, std::uint8_t value, SimTime t) override {
      heard.insert(heard.end(), {address, before, value, static_cast<int>(t)});
    }
    std::vector<int> heard;
  } watcher;
  board_.write_eeprom(3, 1, 10);
  board_.watch_eeprom(watcher);
  board_.write_eeprom(3, 2, 20);
  board_.write_eeprom(board_.spec().eeprom_bytes, 2, 30);
  EXPECT_THAT(watcher.heard, ElementsAre(3, 1, 2, 20));
  EXPECT_EQ(board_.read_eeprom(3), 2);
}

TEST_F(BoardStateTest, PinsThatNoBoardHasDoNoHarm) {
  board_.set_drive(kNoPin, output(true), 0);
  board_.schedule_edge(200, true, 0);
  EXPECT_FALSE(board_.read_level(kNoPin, 0));
  EXPECT_EQ(board_.read_volts(100, 0), 0.0);
}

}  // namespace robosim::exec::board_state_test
