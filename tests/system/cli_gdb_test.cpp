// Tests `robosim run --gdb PORT` with real debuggers: avr-gdb and gdb-multiarch.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <future>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/gdb_client.h"
#include "tests/support/require_target.h"
#include "tests/system/command.h"

namespace robosim::test {
namespace cli_gdb_test {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;

const std::string kDebugged =
    "unsigned passes;\n"                              // 1
    "void blink() {\n"                                // 2
    "  digitalWrite(13, passes % 2);\n"               // 3
    "}\n"                                             // 4
    "void setup() {\n"                                // 5
    "  pinMode(13, OUTPUT);\n"                        // 6
    "  Serial.begin(115200);\n"                       // 7
    "}\n"                                             // 8
    "void loop() {\n"                                 // 9
    "  ++passes;\n"                                   // 10
    "  blink();\n"                                    // 11
    "  Serial.println(millis() + analogRead(A0));\n"  // 12
    "  delay(5);\n"                                   // 13
    "}\n";

std::string field(const Ended& ended, const char* key) {
  const auto json = nlohmann::json::parse(ended.out, nullptr, false);
  return json.is_object() ? json.value(key, "") : ended.out + ended.err;
}

std::vector<std::string> lines_with(const std::string& text, const std::string& part) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    if (line.find(part) != line.npos) lines.push_back(line);
  return lines;
}

struct Debugged {
  const char* target;
  const char* robot;
  const char* debugger;
  const char* package;
  const char* millis;  ///< the Arduino core's millisecond counter
  const char* ram;     ///< the beginning of RAM
};

class CliGdb : public ::testing::TestWithParam<Debugged> {
 protected:
  void SetUp() override {
    const Debugged& d = GetParam();
    ROBOSIM_NEEDS_TARGET(d.target);
    const bool missing = std::system(("command -v " + debugger() + " >/dev/null 2>&1").c_str()) != 0;
    const std::string remedy = debugger() + " is missing: apt install " + d.package;
    if (missing && is_required(d.debugger)) FAIL() << remedy;
    if (missing) GTEST_SKIP() << remedy;
    folder_.write("My/My.ino", kDebugged);
    const Ended built = robosim_command(
        {"build", "My/", "--target", d.target, "--robot", d.robot, "--out", "out"}, folder_.path());
    ASSERT_EQ(built.status, 0) << built.err;
  }
  static std::string debugger() { return GetParam().debugger; }

  Ended run(std::vector<std::string> more = {}) const {
    std::vector<std::string> words{"run",    "out/My.elf", "--map", "oval",  "--robot", GetParam().robot,
                                   "--goal", "none",       "--for", "100ms", "--json"};
    words.insert(words.end(), more.begin(), more.end());
    return robosim_command(words, folder_.path());
  }

  struct Session {
    Ended run;
    std::string gdb;  ///< gdb's output
  };
  /// Starts a run, and gdb with these commands. gdb tries to connect until the run listens. `status` is gdb's
  /// expected exit status: 1 if its last command fails.
  Session debug(const std::string& commands, int status = 0) const {
    const std::string port = std::to_string(free_port());
    folder_.write(
        "commands",
        "set confirm off\nset pagination off\nset width 0\nset tcp connect-timeout 60\ntarget remote :" +
            port + "\n" + commands);
    auto runs = std::async(std::launch::async, [&] { return run({"--gdb", port}); });
    const std::string gdb = "cd '" + folder_.path().string() + "' && timeout 120 " + debugger() +
                            " -nx -batch -x commands out/My.elf >gdb.out 2>&1 </dev/null";
    EXPECT_EQ(WEXITSTATUS(std::system(gdb.c_str())), status);
    return {runs.get(), read_file(folder_ / "gdb.out")};
  }

  const Folder folder_;
};

INSTANTIATE_TEST_SUITE_P(On, CliGdb,
                         ::testing::Values(Debugged{"avr", "uno5", "avr-gdb", "gdb-avr", "timer0_millis",
                                                    "0x800100"},
                                           Debugged{"stm32", "bluepill5", "gdb-multiarch", "gdb-multiarch",
                                                    "robosim_millis", "0x20000000"}),
                         [](const auto& on) { return std::string(on.param.target); });

TEST_P(CliGdb, TheRunIsTheSameAsWithoutADebugger) {
  const Ended alone = run();
  const Session session = debug("continue\n");
  EXPECT_EQ(session.run.out, alone.out) << "the complete result, including trace_hash";
  EXPECT_EQ(session.run.status, 0);
  EXPECT_THAT(session.run.err, AllOf(HasSubstr("waiting for a debugger"), HasSubstr(debugger() + " "),
                                     HasSubstr("out/My.elf -ex 'target remote :")));
  EXPECT_THAT(session.gdb, HasSubstr("exited normally"));
}

TEST_P(CliGdb, TheWorldStandsStillWithTheFirmware) {
  const Ended alone = run();
  const Session session = debug(
      "break My.ino:10\ncontinue\ncontinue\ncontinue\n"
      "print passes\nmonitor time\nprint " +
      std::string(GetParam().millis) + "\ninfo registers\nbacktrace\nx/4xb " + GetParam().ram +
      "\nx/8i $pc\nmonitor time\nprint " + GetParam().millis +
      "\n"
      "step\nprint passes\nnext\nstepi\nstepi\n"
      "delete\nwatch passes\ncontinue\nprint passes\n"
      // Breaks at the function's name, because avr-gcc 14 inlines digitalWrite() and has no instruction for
      // line 3.
      "delete\nbreak blink\ncontinue\nprint passes % 2\n"
      "delete\ncontinue\n");
  SCOPED_TRACE(session.gdb);
  EXPECT_EQ(session.run.out, alone.out) << "the complete result, including trace_hash";
  EXPECT_THAT(session.gdb, HasSubstr("Breakpoint 1, loop () at My.ino:10"));
  EXPECT_THAT(session.gdb, HasSubstr("$1 = 2\n")) << "the third pass begins after two complete passes";
  EXPECT_THAT(session.gdb, HasSubstr("Hardware watchpoint 2: passes\n\nOld value = 3\nNew value = 4"));
  EXPECT_THAT(session.gdb, HasSubstr("Breakpoint 3, "));
  EXPECT_THAT(session.gdb, HasSubstr("exited normally"));

  const auto times = lines_with(session.gdb, "s simulated, cycle ");
  ASSERT_EQ(times.size(), 2u);
  EXPECT_EQ(times[0], times[1]) << "no time passes while the firmware is halted";
  const auto millis = lines_with(session.gdb, "$");
  ASSERT_GE(millis.size(), 3u);
  EXPECT_EQ(millis[1].substr(5), millis[2].substr(5)) << "millis()";
}

TEST_P(CliGdb, GoesBack) {
  const Ended alone = run();
  const std::string there = "break My.ino:10\ncontinue\ncontinue\ncontinue\n";
  const Session session =
      debug(there +
            "print $pc\nreverse-stepi\nstepi\nprint $pc\n"
            "reverse-continue\nprint passes\nreverse-step\n"
            "delete\nwatch passes\nreverse-continue\nprint passes\nbacktrace\n"
            "continue\ncontinue\ncontinue\nprint passes\ndelete\nreverse-continue\ncontinue\n");
  SCOPED_TRACE(session.gdb);
  EXPECT_EQ(session.run.out, alone.out) << "the complete result, including trace_hash";
  const auto values = lines_with(session.gdb, "$");
  ASSERT_EQ(values.size(), 5u);
  EXPECT_EQ(values[0].substr(5), values[1].substr(5)) << "a step back and a step forward";
  EXPECT_EQ(values[2], "$3 = 1");
  EXPECT_EQ(values[3], "$4 = 0");
  EXPECT_EQ(values[4], "$5 = 3");
  EXPECT_THAT(session.gdb, HasSubstr("Hardware watchpoint 2: passes\n\nOld value = 1\nNew value = 0\n"));
  EXPECT_THAT(session.gdb, HasSubstr("#0  0x")) << "halts in the middle of the line that wrote `passes`";
  EXPECT_THAT(session.gdb, HasSubstr("in loop () at My.ino:10"));
  // gdb 13 and gdb 16 word the start of the run differently.
  EXPECT_THAT(session.gdb, AnyOf(HasSubstr("No more reverse-execution history"),
                                 HasSubstr("Reached end of recorded history; stopping.\n"
                                           "Backward execution from here not possible.")));
  EXPECT_THAT(session.gdb, HasSubstr("exited normally"));
}

TEST_P(CliGdb, AfterADetachTheRunGoesOnAlone) {
  const Ended alone = run();
  for (const char* commands : {"break My.ino:10\ncontinue\ndetach\n",
                               "break My.ino:10\ncontinue\ndisconnect\n", "break My.ino:10\ncontinue\n"}) {
    SCOPED_TRACE(commands);
    EXPECT_EQ(debug(commands).run.out, alone.out);
  }
}

TEST_P(CliGdb, KillEndsTheRun) {
  const Session session = debug("break My.ino:10\ncontinue\nkill\n");
  EXPECT_EQ(field(session.run, "verdict"), "interrupted");
  EXPECT_EQ(session.run.status, 130);
}

TEST_P(CliGdb, WhatCannotBeDebuggedIsSaidInOneSentence) {
  const Port taken;
  const std::string port = std::to_string(taken.number());
  Ended ended = run({"--gdb", port});
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.err, HasSubstr("port " + port + " is in use"));
  for (const char* wrong : {"0", "65536", "-1", "gdb"}) {
    ended = run({"--gdb", wrong});
    EXPECT_EQ(ended.status, 2) << wrong;
    EXPECT_THAT(ended.err, HasSubstr("--gdb")) << wrong;
  }
  ended = robosim_command({"run", "My/", "--gdb", "3333"}, folder_.path());
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.err, AllOf(HasSubstr("--gdb"), HasSubstr("--target avr")));
}

}  // namespace cli_gdb_test
}  // namespace robosim::test
