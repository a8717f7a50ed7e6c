#include "sim/exec/gdb/server.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "sim/base/error.h"
#include "sim/exec/gdb/history.h"
#include "tests/support/gdb_client.h"

namespace robosim::exec::gdb::gdb_server_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// A fake processor with two registers of two bytes, and sixteen bytes of memory at 0x100.
class Fake final : public Processor {
 public:
  std::string registers() const override { return registers_[0] + registers_[1]; }
  std::string read_register(unsigned number) const override { return number < 2 ? registers_[number] : ""; }
  bool write_register(unsigned number, std::string_view bytes) override {
    if (number > 1 || bytes.size() != 2) return false;
    registers_[number] = bytes;
    return true;
  }
  std::string read_memory(std::uint32_t address, std::uint32_t size) const override {
    return address < 0x100 || address >= 0x110 ? "" : memory_.substr(address - 0x100, size);
  }
  bool write_memory(std::uint32_t address, std::string_view bytes) override {
    if (address < 0x100 || address + bytes.size() > 0x110) return false;
    memory_.replace(address - 0x100, bytes.size(), bytes);
    return true;
  }
  bool set_breakpoint(std::uint32_t address, bool set) override {
    stops.push_back((set ? "break " : "no break ") + std::to_string(address));
    return address % 2 == 0;
  }
  bool set_watchpoint(std::uint32_t address, std::uint32_t size, Access access, bool set) override {
    stops.push_back((set ? "watch " : "no watch ") + std::to_string(address) + " " + std::to_string(size));
    return access == Access::write;
  }
  std::string monitor(const std::string& command) override { return "did " + command; }

  std::vector<std::string> stops;

 private:
  std::string registers_[2] = {"\x01\x02", "\x03\x04"};
  std::string memory_ = "0123456789abcdef";
};

struct Past final : History {
  bool reaches_back() const override { return true; }
  bool is_at_front() const override { return at_front; }
  void forget() override { ++forgotten; }
  bool at_front = true;
  int forgotten = 0;
};

class GdbServer : public testing::Test {
 protected:
  /// Sends these packets to the halted processor, followed by "continue". Returns the replies to the packets.
  std::vector<std::string> ask(const std::vector<std::string>& packets) {
    for (const std::string& packet : packets) gdb_.say(packet);
    gdb_.say("c");
    EXPECT_EQ(server_.stand_still(processor_, {}), Server::Order::go);
    std::vector<std::string> replies;
    if (met_) {
      EXPECT_EQ(gdb_.reply(), "S05");
    }
    met_ = true;
    for (std::size_t i = 0; i < packets.size(); ++i) replies.push_back(gdb_.reply());
    return replies;
  }

  std::atomic<bool> interrupted_{false};
  const std::uint16_t port_ = test::free_port();
  Server server_{port_, interrupted_};
  test::GdbClient gdb_{port_};
  Fake processor_;
  bool met_ = false;
};

TEST_F(GdbServer, ReadsAndWritesRegisters) {
  EXPECT_THAT(ask({"?", "g", "p1", "p2", "P1=aabb", "p1", "P7=aabb", "G11223344", "g", "G1122"}),
              ElementsAre("S05", "01020304", "0304", "E01", "OK", "aabb", "E01", "OK", "11223344", "OK"));
}

TEST_F(GdbServer, ReadsAndWritesMemory) {
  EXPECT_THAT(ask({"m100,4", "m10e,10", "m200,1", "M100,2:5859", "m100,3", "M10f,2:5859", "M100,3:5859"}),
              ElementsAre("30313233", "6566", "E01", "OK", "585932", "E01", "E01"));
}

TEST_F(GdbServer, SetsAndClearsStops) {
  EXPECT_THAT(ask({"Z0,10,2", "z0,10,2", "Z1,11,2", "Z2,100,4", "Z3,100,1", "z2,100,4", "Z9,0,0"}),
              ElementsAre("OK", "OK", "E01", "OK", "E01", "OK", ""));
  EXPECT_THAT(processor_.stops, ElementsAre("break 16", "no break 16", "break 17", "watch 256 4",
                                            "watch 256 1", "no watch 256 4"));
}

TEST_F(GdbServer, AnswersNothingToWhatItDoesNotKnowAndRefusesWhatIsMalformed) {
  EXPECT_THAT(ask({"vMustReplyEmpty", "qfThreadInfo", "m", "mxyz", "M100", "P", "p9", "Z", "Z0", "g!"}),
              ElementsAre("", "", "E01", "E01", "E01", "E01", "E01", "E01", "E01", "01020304"));
}

TEST_F(GdbServer, PassesMonitorCommandsOn) {
  EXPECT_THAT(ask({"qRcmd,74696d65"}), ElementsAre("6469642074696d65")) << "“did time” in hexadecimal";
}

TEST_F(GdbServer, SaysWhyTheProcessorStandsStill) {
  ask({});
  gdb_.say("s");
  EXPECT_EQ(server_.stand_still(processor_, {Signal::fault, {}, 0}), Server::Order::step);
  EXPECT_EQ(gdb_.reply(), "S0b");
  gdb_.say("c");
  server_.stand_still(processor_, {Signal::trap, Access::write, 0x800123});
  EXPECT_EQ(gdb_.reply(), "T05watch:800123;");
}

TEST_F(GdbServer, GoesBackOnlyWhereThatCanBeDone) {
  EXPECT_THAT(ask({"qSupported", "bs", "bc"}), ElementsAre("PacketSize=2000;QStartNoAckMode+", "", ""));
  Past past;
  server_.go_back_in(past);
  EXPECT_THAT(ask({"qSupported", "b", "bx"}),
              ElementsAre(HasSubstr(";ReverseStep+;ReverseContinue+"), "", ""));
  gdb_.say("bs");
  EXPECT_EQ(server_.stand_still(processor_, {}), Server::Order::step_back);
  gdb_.say("bc");
  EXPECT_EQ(server_.stand_still(processor_, {.edge = Edge::begin}), Server::Order::go_back);
  EXPECT_EQ(gdb_.reply(), "S05");
  EXPECT_EQ(gdb_.reply(), "T05replaylog:begin;");
}

TEST_F(GdbServer, WhatIsWrittenEndsThePastAndThePastIsNotWritten) {
  Past past;
  server_.go_back_in(past);
  EXPECT_THAT(ask({"M100,2:5859", "P1=aabb", "P7=aabb"}), ElementsAre("OK", "OK", "E01"));
  EXPECT_EQ(past.forgotten, 2);
  past.at_front = false;
  EXPECT_THAT(ask({"M100,2:3031", "P1=ccdd", "G11223344", "m100,2", "g"}),
              ElementsAre("E01", "E01", "E01", "5859", "0102aabb"));
  EXPECT_EQ(past.forgotten, 2);
}

TEST_F(GdbServer, CtrlCAsksForAHaltOnce) {
  ask({});
  EXPECT_FALSE(server_.asks_to_halt());
  gdb_.press_ctrl_c();
  EXPECT_TRUE(server_.asks_to_halt());
  EXPECT_FALSE(server_.asks_to_halt());
}

TEST_F(GdbServer, APacketThatGotDamagedIsAskedForAgain) {
  gdb_.send_bytes("$g#00");
  EXPECT_THAT(ask({"p1"}), ElementsAre("0304")) << "the damaged packet gets no reply";
}

TEST_F(GdbServer, DetachingLetsTheRunGoOnAlone) {
  gdb_.say("D");
  EXPECT_TRUE(server_.attached()) << "the debugger stays attached until the run continues";
  EXPECT_EQ(server_.stand_still(processor_, {}), Server::Order::go);
  EXPECT_FALSE(server_.attached());
  EXPECT_EQ(gdb_.reply(), "OK");
  EXPECT_EQ(gdb_.reply(), "(gone)");
  EXPECT_FALSE(interrupted_);
}

TEST_F(GdbServer, ADebuggerThatGoesIsLikeOneThatDetaches) {
  gdb_.leave();
  EXPECT_EQ(server_.stand_still(processor_, {}), Server::Order::go);
  EXPECT_FALSE(server_.attached());
  EXPECT_FALSE(interrupted_);
}

TEST_F(GdbServer, KillingInterruptsTheRun) {
  gdb_.say("k");
  EXPECT_EQ(server_.stand_still(processor_, {}), Server::Order::go);
  EXPECT_FALSE(server_.attached());
  EXPECT_TRUE(interrupted_);
}

TEST_F(GdbServer, AnInterruptedRunWaitsForNobody) {
  interrupted_ = true;
  EXPECT_EQ(server_.stand_still(processor_, {}), Server::Order::go);
  EXPECT_FALSE(server_.attached());
}

TEST_F(GdbServer, TellsTheEndOfTheRun) {
  ask({});
  server_.ended(1);
  EXPECT_EQ(gdb_.reply(), "W01");
}

TEST(GdbPort, IsRefusedWhereSomebodyListens) {
  const test::Port taken;
  std::atomic<bool> interrupted{false};
  EXPECT_THAT([&] { Server(taken.number(), interrupted); },
              ThrowsMessage<InputError>(HasSubstr("is in use by another program")));
}

}  // namespace robosim::exec::gdb::gdb_server_test
