// Tests an emulated AVR under gdb. One thread suffices, because the tests send gdb's packets before the AVR
// runs.

#include <fmt/format.h>

#include <optional>

#include "sim/exec/avr/firmware.h"
#include "sim/exec/gdb/server.h"
#include "tests/support/gdb_client.h"
#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec::debug_test {

using testing::ElementsAre;

// The sketch uses handlers, pin edges, PWM and the UART, all of which a halt could disturb.
const std::string kBusy = R"(volatile unsigned passes;
void setup() {
  pinMode(13, OUTPUT);
  Serial.begin(115200);
  tone(8, 1000);
}
void loop() {
  ++passes;
  digitalWrite(13, passes & 1);
  analogWrite(5, passes);
  Serial.println(micros());
}
)";

class DebugTest : public AvrTest {
 protected:
  void before_power_on() override {
    if (!debugged_) return;
    const std::uint16_t port = test::free_port();
    server_.emplace(port, interrupted_);
    gdb_.emplace(port);
    avr_->debug_with(*server_);
  }

  /// Sends a packet that gets one reply. replies() returns the replies to all packets.
  void ask(const std::string& packet) {
    gdb_->say(packet);
    ++asked_;
  }
  /// Resumes the chip. If the chip halts again, replies() has one more reply.
  void go(const char* order = "c") { gdb_->say(order); }
  std::vector<std::string> replies(int halts = 0) {
    std::vector<std::string> texts;
    for (int i = asked_ + halts; i > 0; --i) {
      texts.push_back(gdb_->reply());
      if (texts.back() == "(gone)") ADD_FAILURE() << i << " replies are missing";
      if (texts.back() == "(gone)") i = 0;
    }
    texts.resize(static_cast<std::size_t>(asked_ + halts));
    asked_ = 0;
    return texts;
  }
  std::uint32_t address_of(const char* name) const {
    const auto firmware = avr::Firmware::read(built_.image, *find_board("uno"));
    const auto data = firmware.find_variable(name);
    return data ? 0x800000u + *data : firmware.find(name).value_or(0);
  }
  static std::string from_hex(const std::string& hex) {
    std::string text;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
      text += static_cast<char>(std::stoul(hex.substr(i, 2), nullptr, 16));
    return text;
  }
  static std::uint32_t number(const std::string& hex) {  // the bytes are little endian
    std::uint32_t value = 0;
    for (std::size_t i = hex.size(); i >= 2; i -= 2)
      value = value << 8 | static_cast<std::uint32_t>(std::stoul(hex.substr(i - 2, 2), nullptr, 16));
    return value;
  }
  /// Returns all output of the board.
  std::string trace() const {
    std::string text = serial_;
    for (const SimTime t : byte_times_) text += fmt::format(" {}", t);
    for (const PinEvent& event : pins_)
      text += fmt::format(" {}:{}:{}@{}", event.pin, event.drive.level, event.drive.duty, event.at);
    return text;
  }

  bool debugged_ = true;
  std::atomic<bool> interrupted_{false};
  std::optional<gdb::Server> server_;
  std::optional<test::GdbClient> gdb_;
  int asked_ = 0;
};

class DebugTrace : public DebugTest {
 protected:
  void SetUp() override {
    DebugTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    debugged_ = false;
    output(kBusy, 30 * kMillisecond);
    alone_ = trace();
    debugged_ = true;
    start(kBusy);
  }
  std::string alone_;
};

TEST_F(DebugTrace, IsTheSameWithBreakpoints) {
  ask(fmt::format("Z0,{:x},2", address_of("__vector_16")));
  ask(fmt::format("Z0,{:x},2", address_of("__vector_7")));
  constexpr int kHalts = 60;
  for (int i = 0; i <= kHalts; ++i) go();
  ask("D");
  run(30 * kMillisecond);
  EXPECT_EQ(trace(), alone_);
  EXPECT_EQ(replies(kHalts).back(), "S05");
}

TEST_F(DebugTrace, IsTheSameWithAWatchpoint) {
  ask(fmt::format("Z2,{:x},2", address_of("passes")));
  constexpr int kHalts = 20;
  for (int i = 0; i <= kHalts; ++i) go();
  ask(fmt::format("m{:x},2", address_of("passes")));
  ask(fmt::format("z2,{:x},2", address_of("passes")));
  go();
  run(30 * kMillisecond);
  EXPECT_EQ(trace(), alone_);
  const auto texts = replies(kHalts + 1);
  EXPECT_EQ(texts[1], fmt::format("T05watch:{:x};", address_of("passes")));
  EXPECT_EQ(number(texts[texts.size() - 2]), kHalts + 1u);
}

TEST_F(DebugTrace, IsTheSameWithSteps) {
  constexpr int kSteps = 4000;
  for (int i = 0; i < kSteps; ++i) go("s");
  go();
  run(30 * kMillisecond);
  EXPECT_EQ(trace(), alone_);
}

TEST_F(DebugTrace, IsTheSameAfterADebuggerThatJustLooked) {
  for (const char* look : {"?", "g", "m800020,e0", "m800100,700", "m0,800", "m810000,400", "p22"}) ask(look);
  go();
  run(30 * kMillisecond);
  EXPECT_EQ(trace(), alone_);
}

TEST_F(DebugTest, WaitsBeforeTheFirstInstruction) {
  start("void setup() {} void loop() {}");
  ask("?");
  ask("qRcmd,74696d65");  // the command "time"
  go();
  run(kMillisecond);
  const auto texts = replies();
  EXPECT_EQ(texts[0], "S05");
  EXPECT_EQ(from_hex(texts[1]), "0.000000000 s simulated, cycle 0\n");
}

TEST_F(DebugTest, AStepGoesThroughHandlersToTheNextInstructionOfTheSketch) {
  start("volatile unsigned n; void setup() {} void loop() { for (;;) ++n; }");
  const auto firmware = avr::Firmware::read(built_.image, *find_board("uno"));
  go();
  run(5 * kMillisecond);
  // Timer 0's period is 24 us longer than a tick, so its handler starts 24 us later in each tick. Within 45
  // ticks, the handler therefore interrupts the steps several times.
  constexpr int kTicks = 45, kSteps = 150;
  for (int tick = 0; tick < kTicks; ++tick) {
    gdb_->press_ctrl_c();
    for (int i = 0; i < kSteps; ++i) {
      go("s");
      ask("p22");
    }
    go();
    run(kMillisecond);
    const auto texts = replies(1 + kSteps);
    EXPECT_EQ(texts[0], "S02");
    for (std::size_t i = 2; i < texts.size(); i += 2) {
      const Symbol* function = firmware.function_at(number(texts[i]));
      ASSERT_TRUE(function);
      ASSERT_NE(function->name, "__vector_16");
    }
  }
}

TEST_F(DebugTest, ABreakpointHoldsInAHandlerToo) {
  start("void setup() {} void loop() {}");
  ask(fmt::format("Z0,{:x},2", address_of("__vector_16")));
  go();
  ask("p22");
  gdb_->say("D");
  run(2 * kMillisecond);
  EXPECT_EQ(number(replies(1).back()), address_of("__vector_16"));
}

TEST_F(DebugTest, FlashReadsAsItWasFlashedAndCannotBeChanged) {
  start(kBusy);
  const std::uint32_t handler = address_of("__vector_7");
  ask(fmt::format("m{:x},4", handler));
  ask(fmt::format("Z0,{:x},2", handler));
  ask(fmt::format("m{:x},4", handler));
  ask(fmt::format("M{:x},2:0000", handler));
  ask("m7fff,4");
  ask("m800900,1");
  gdb_->say("D");
  run(kMillisecond);
  const auto texts = replies();
  EXPECT_EQ(texts[0], texts[2]);
  EXPECT_EQ(texts[3], "E01");
  EXPECT_EQ(texts[4], "ff") << "the flash ends after this byte";
  EXPECT_EQ(texts[5], "E01");
}

TEST_F(DebugTest, WritingARegisterOfThePeripheralsDoesWhatFirmwareWouldDo) {
  start("void setup() { pinMode(13, OUTPUT); } void loop() {}");
  go();
  run(kMillisecond);
  gdb_->press_ctrl_c();
  ask("M800025,1:20");  // PORTB, bit 5
  go();
  run(kMillisecond);
  EXPECT_TRUE(pins_.back().pin == 13 && pins_.back().drive.level);
}

TEST_F(DebugTest, WritingAVariableAndTheProgramCounterChangesWhatHappens) {
  start("volatile int n = 7; void setup() { Serial.begin(115200); Serial.print(n); } void loop() {}");
  ask(fmt::format("Z0,{:x},2", address_of("main")));
  go();
  ask(fmt::format("M{:x},2:2a00", address_of("n")));
  ask("z0," + fmt::format("{:x},2", address_of("main")));
  go();
  run(20 * kMillisecond);
  EXPECT_EQ(serial_, "42");
}

TEST_F(DebugTest, ACrashHaltsWhereItHappened) {
  start("volatile int* p = (int*)0x4000; void setup() {} void loop() { *p = 1; }");
  go();
  go();
  run(5 * kMillisecond);
  EXPECT_EQ(replies(1)[0], "S0b");
  ASSERT_TRUE(avr_->crash());
}

TEST_F(DebugTest, BreakpointsOutliveAPowerCycle) {
  start("void setup() {} void loop() {}");
  ask(fmt::format("Z0,{:x},2", address_of("main")));
  go();
  go();
  run(5 * kMillisecond);
  avr_->power_off(now_);
  run(5 * kMillisecond);
  avr_->power_on(now_);
  go();
  run(5 * kMillisecond);
  EXPECT_THAT(replies(2), ElementsAre("OK", "S05", "S05"));
}

TEST_F(DebugTest, ASleepingChipIsHaltedAndSteppedToo) {
  start("#include <avr/sleep.h>\nvoid setup() {} void loop() { sleep_mode(); }");
  go();
  run(5 * kMillisecond);
  gdb_->press_ctrl_c();
  go("s");
  go();
  run(5 * kMillisecond);
  EXPECT_THAT(replies(2), ElementsAre("S02", "S05"));
}

TEST_F(DebugTest, AfterADetachNoBreakpointIsLeft) {
  start(kBusy);
  ask(fmt::format("Z0,{:x},2", address_of("__vector_7")));
  ask("D");
  run(30 * kMillisecond);
  EXPECT_FALSE(avr_->crash());
  EXPECT_FALSE(serial_.empty());
}

}  // namespace robosim::exec::debug_test
