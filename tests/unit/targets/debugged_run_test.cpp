// Tests a run under a debugger that can step backward. Checks where the run halts. Also checks that the run's
// events, output and result equal those of a run without a debugger. gdb's packets are sent in advance.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <stdlib.h>

#include <random>
#include <string>
#include <vector>

#include "sim/base/file.h"
#include "sim/build/sketch.h"
#include "sim/robot/description.h"
#include "sim/runner/debugged_run.h"
#include "tests/support/gdb_client.h"
#include "tests/support/require_target.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/targets/target.h"

namespace robosim::runner::debugged_run_test {

using testing::HasSubstr;

// A sketch that uses the interrupt handlers of the Arduino core, and drives from its 20th pass on. It crashes
// when it receives an "x".
const std::string kSketch = R"(volatile unsigned passes;
__attribute__((noinline)) void pass() { ++passes; }
__attribute__((noinline)) void crash() { *(volatile int*)0x4000 = 1; }
void setup() {
  pinMode(13, OUTPUT);
  Serial.begin(115200);
}
void loop() {
  pass();
  digitalWrite(13, passes & 1);
  Serial.println(micros());
  if (passes % 4 == 0) delay(30);
  if (passes == 20) {
    pinMode(7, OUTPUT);
    digitalWrite(7, HIGH);
    analogWrite(5, 90);
  }
  if (Serial.read() == 'x') crash();
}
)";

struct Told final : run::Listener {
  void sampled(const run::Sample& s) override {
    lines.push_back(fmt::format("{} at {} {}", s.t, s.pose.position.x, s.left));
  }
  void pin_changed(Pin pin, const PinDrive& drive, SimTime t) override {
    lines.push_back(fmt::format("{} pin {} {} {}", t, pin, drive.level, drive.duty));
  }
  void byte_sent(std::uint8_t byte, SimTime t) override {
    lines.push_back(fmt::format("{} byte {}", t, byte));
  }
  bool wants_inputs() const override { return hears_inputs; }
  void level_seen(Pin pin, bool level, SimTime t) override {
    lines.push_back(fmt::format("{} sees {} {}", t, pin, level));
  }
  void happened(const result::RunEvent& event) override {
    lines.push_back(fmt::format("{} {}", event.t_ns, result::text_of(event)));
  }
  bool hears_inputs = false;
  std::vector<std::string> lines;
};

class DebuggedRunTest : public testing::TestWithParam<exec::Target> {
 protected:
  void SetUp() override {
    ROBOSIM_NEEDS_TARGET(GetParam().name);
    test::use_shared_cache();
    const std::filesystem::path folder = folder_.path() / "Debugged";
    std::filesystem::create_directories(folder);
    write_file(folder / "Debugged.ino", kSketch);
    build::Request request{folder, *robot_.board};
    request.target = GetParam().name;
    image_ = build::build(request).image;
  }

  run::Setup setup(exec::Executor& executor, Told& told) const {
    run::Setup setup;
    setup.map = &map_;
    setup.agents = {{.robot = &robot_,
                     .executor = &executor,
                     .goal = judge::parse_goal(goal_),
                     .scenario = scenario::parse_scenario(script_, "s.txt"),
                     .listener = &told}};
    setup.limit = limit_;
    setup.samples_every = 20 * kMillisecond;
    setup.interrupted = &interrupted_;
    return setup;
  }
  static std::string text_of(const judge::Outcome& o) {
    return fmt::format("{} {} {} {}", o.trace_hash, o.why, o.time, o.serial);
  }

  void say(const std::string& packet) { packets_.push_back(packet); }
  /// Sends a gdb packet that resumes the run, then queries the program counter and the time at the next halt.
  void go(const std::string& order) {
    for (const std::string& packet :
         {order, "p" + std::string(GetParam().program_counter), std::string("qRcmd,74696d65")})
      say(packet);
  }
  /// Runs the sketch with the packets of say() and go(). Compares the result with a run without a debugger.
  /// Returns all replies.
  std::vector<std::string> run() {
    Told alone, told;
    alone.hears_inputs = told.hears_inputs = hears_inputs_;
    const auto untouched = GetParam().make_executor(*robot_.board, image_);
    const auto executor = GetParam().make_executor(*robot_.board, image_);
    const judge::Outcome due = std::move(run::simulate(setup(*untouched, alone)).front());
    const std::uint16_t port = test::free_port();
    exec::gdb::Server server(port, interrupted_);
    test::GdbClient gdb(port);
    for (const std::string& packet : packets_) gdb.say(packet);
    executor->chip_access()->debug_with(server);
    outcome_ = DebuggedRun(setup(*executor, told), server).go();
    if (!writes_) {
      EXPECT_EQ(text_of(outcome_), text_of(due));
      EXPECT_EQ(told.lines, alone.lines);
    }
    server.ended(0);
    std::vector<std::string> replies;
    while (replies.empty() || (replies.back() != "(gone)" && replies.back() != "W00"))
      replies.push_back(gdb.reply());
    replies.pop_back();
    return replies;
  }
  /// The replies to one call of go().
  struct Halt {
    std::string why;
    std::uint32_t pc = 0;
    std::string time;
  };
  static std::vector<Halt> halts(const std::vector<std::string>& replies) {
    std::vector<Halt> all;
    for (std::size_t i = 0; i + 2 < replies.size(); ++i) {
      const std::string& why = replies[i];
      if (why[0] != 'S' && why[0] != 'T') continue;
      std::string time;
      for (std::size_t c = 0; c + 1 < replies[i + 2].size(); c += 2)
        time += static_cast<char>(std::stoul(replies[i + 2].substr(c, 2), nullptr, 16));
      const std::string& pc = replies[i + 1];  // the least significant byte comes first
      const std::string number = pc.substr(6, 2) + pc.substr(4, 2) + pc.substr(2, 2) + pc.substr(0, 2);
      all.push_back({why, static_cast<std::uint32_t>(std::stoul(number, nullptr, 16)), time});
    }
    return all;
  }
  std::uint32_t address_of(const char* name) const {
    return GetParam().address_of(image_, *robot_.board, name);
  }
  std::string breakpoint(const char* name) const { return fmt::format("Z0,{:x},2", address_of(name)); }
  std::string none(const char* name) const { return fmt::format("z0,{:x},2", address_of(name)); }

  const map::Map map_ = map::read_map(map::find_map("oval"));
  const robot::Description robot_ = robot::load_description(GetParam().robot_of_five);
  const test::TemporaryFolder folder_;
  std::filesystem::path image_;
  std::string script_, goal_ = "none";
  SimTime limit_ = 300 * kMillisecond;
  bool hears_inputs_ = false, writes_ = false;
  std::vector<std::string> packets_;
  std::atomic<bool> interrupted_{false};
  judge::Outcome outcome_;
};

INSTANTIATE_TEST_SUITE_P(, DebuggedRunTest, testing::ValuesIn(exec::targets({"avr", "stm32"})),
                         exec::name_of);

/// Expects that the halts after `places[turn]` equal the halts before `places[turn]`, in reverse order.
void expect_mirrored(const std::vector<std::string>& places, std::size_t turn) {
  ASSERT_EQ(places.size(), 2 * turn + 1);
  for (std::size_t i = 0; i < turn; ++i) EXPECT_EQ(places[turn + 1 + i], places[turn - 1 - i]) << i;
}

TEST_P(DebuggedRunTest, StepsGoBackAsTheyWentForth) {
  constexpr int kSteps = 400;  // including steps in interrupt handlers
  say(breakpoint("_Z4passv"));
  go("c");
  say(none("_Z4passv"));
  for (const char* order : {"s", "bs"})
    for (int i = 0; i < kSteps; ++i) go(order);
  say("c");
  std::vector<std::string> places;
  for (const Halt& halt : halts(run())) places.push_back(fmt::format("{:x} {}", halt.pc, halt.time));
  expect_mirrored(places, kSteps);
}

TEST_P(DebuggedRunTest, BreakpointsAreMetBackAsTheyWereForth) {
  constexpr int kHalts = 70;  // enough to pass several snapshots
  say(breakpoint("_Z4passv"));
  say(breakpoint(GetParam().clock_handler));
  for (int i = 0; i <= kHalts; ++i) go("c");
  for (int i = 0; i < kHalts; ++i) go("bc");
  go("bc");
  say("D");
  const std::vector<Halt> all = halts(run());
  std::vector<std::string> places;
  for (const Halt& halt : all) places.push_back(fmt::format("{} {:x} {}", halt.why, halt.pc, halt.time));
  EXPECT_THAT(places.back(), HasSubstr("T05replaylog:begin; "));
  EXPECT_THAT(places.back(), HasSubstr("0.000000000 s simulated"));
  places.pop_back();
  expect_mirrored(places, kHalts);
}

TEST_P(DebuggedRunTest, AWatchpointHaltsBackInFrontOfWhoHasWritten) {
  const std::uint32_t passes = address_of("passes"), pass = address_of("_Z4passv");
  say(fmt::format("Z2,{:x},1", passes));
  for (int i = 0; i < 9; ++i) go("c");
  say(fmt::format("m{:x},1", passes));
  for (int i = 0; i < 6; ++i) {
    go("bc");
    say(fmt::format("m{:x},1", passes));
  }
  say("D");
  const std::vector<std::string> replies = run();
  std::vector<std::string> values;
  for (const std::string& reply : replies)
    if (reply.size() == 2 && reply != "OK") values.push_back(reply);
  EXPECT_THAT(values, testing::ElementsAre("09", "08", "07", "06", "05", "04", "03"));
  const std::vector<Halt> all = halts(replies);
  ASSERT_EQ(all.size(), 15u);
  EXPECT_EQ(all.back().why, fmt::format("T05watch:{:x};", passes));
  EXPECT_TRUE(all.back().pc > pass && all.back().pc < pass + 20) << "halts after the instruction that writes";
}

TEST_P(DebuggedRunTest, ACrashIsGoneBackFrom) {
  script_ = "at 150ms send \"x\"";
  go("c");
  go("bs");
  go("bs");
  go("s");
  go("s");
  go("c");
  say("c");
  const std::vector<Halt> all = halts(run());
  ASSERT_EQ(all.size(), 6u);
  EXPECT_EQ(all[0].why, "S0b");
  EXPECT_LT(all[1].pc, all[0].pc) << "halts at the previous instruction";
  EXPECT_GE(all[1].pc + 4, all[0].pc);
  EXPECT_LT(all[2].time, all[1].time);
  EXPECT_EQ(all[3].time, all[1].time);
  EXPECT_EQ(all[5].why, "S0b");
  EXPECT_EQ(all[5].time, all[0].time);
  EXPECT_EQ(outcome_.verdict, judge::Verdict::crashed);
}

TEST_P(DebuggedRunTest, APowerCutIsGoneBackOver) {
  script_ = "at 100ms power off for 40ms\nat 200ms power off for 5ms";
  say(breakpoint("main"));
  for (int i = 0; i < 3; ++i) go("c");
  for (int i = 0; i < 3; ++i) go("bc");
  for (int i = 0; i < 3; ++i) go("c");
  say("c");
  const std::vector<Halt> all = halts(run());
  ASSERT_EQ(all.size(), 9u);
  for (const std::size_t i : {0u, 1u, 2u}) {
    EXPECT_EQ(all[i].pc, address_of("main"));
    EXPECT_EQ(all[6 + i].time, all[i].time);
  }
  EXPECT_EQ(all[3].time, all[1].time);
  EXPECT_EQ(all[4].time, all[0].time);
  EXPECT_EQ(all[5].why, "T05replaylog:begin;");
}

TEST_P(DebuggedRunTest, WhatIsToldIsToldOnceHoweverItGoesBackAndForth) {
  script_ = "at 60ms lift for 20ms\nat 130ms power off for 15ms\nat 210ms fault left weak 0.6 for 50ms";
  hears_inputs_ = true;
  say(breakpoint("_Z4passv"));
  say(fmt::format("Z2,{:x},2", address_of(GetParam().clock_variable)));
  std::mt19937 random(3);
  for (int i = 0; i < 150; ++i) {
    constexpr const char* kOrders[] = {"c", "c", "c", "s", "bs", "bc"};
    go(kOrders[random() % std::size(kOrders)]);
  }
  say(none("_Z4passv"));
  go("bc");
  go("bc");
  say("D");
  EXPECT_EQ(halts(run()).size(), 152u);
}

TEST_P(DebuggedRunTest, APastIsNotChangedAndAPresentThatIsHasNone) {
  const std::string write = fmt::format("M{:x},2:0700", address_of("passes"));
  writes_ = true;
  say(breakpoint("_Z4passv"));
  for (int i = 0; i < 3; ++i) go("c");
  go("bc");
  go("bc");
  say(write);
  go("c");
  go("c");
  say(write);
  go("bs");
  for (int i = 0; i < 12; ++i) go("c");
  go("bc");
  say("D");
  std::vector<std::string> kinds;
  for (const std::string& reply : run())
    if (reply == "E01" || reply == "OK" || reply[0] == 'T' || reply[0] == 'S')
      kinds.push_back(reply.substr(0, 16));
  const std::vector<std::string> due = {
      "OK", "S05", "S05", "S05", "S05", "S05", "E01", "S05", "S05", "OK", "T05replaylog:beg"};
  EXPECT_EQ(std::vector<std::string>(kinds.begin(), kinds.begin() + 11), due);
  EXPECT_EQ(kinds[kinds.size() - 2], "S05") << "stepping back works again after the next snapshot";
}

TEST_P(DebuggedRunTest, AnEndThatIsNoGoodHaltsOnceMore) {
  goal_ = "laps:1";
  go("c");
  go("bs");
  go("s");
  go("c");
  say("c");
  const std::vector<std::string> replies = run();
  const std::vector<Halt> all = halts(replies);
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[0].why, "T05replaylog:end;");
  EXPECT_EQ(all[2].time, all[0].time);
  EXPECT_EQ(all[3].why, "T05replaylog:end;");
  EXPECT_EQ(all[3].time, all[0].time);
  EXPECT_EQ(outcome_.verdict, judge::Verdict::timeout);
}

TEST_P(DebuggedRunTest, ARunThatIsKilledInItsPastEndsWhereItHadComeTo) {
  writes_ = true;
  say(breakpoint(GetParam().clock_handler));
  for (int i = 0; i < 60; ++i) say("c");
  for (int i = 0; i < 50; ++i) say("bc");
  say("k");
  run();
  EXPECT_EQ(outcome_.verdict, judge::Verdict::interrupted);
  EXPECT_GT(outcome_.time, 50 * kMillisecond);
}

}  // namespace robosim::runner::debugged_run_test
