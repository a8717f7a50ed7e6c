// Tests `robosim run --view` on a terminal.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/system/on_terminal.h"

namespace robosim::test {
namespace cli_view_test {

using ::testing::HasSubstr;

constexpr const char* kEnter = "\033[?1049h\033[?25l";
constexpr const char* kLeave = "\033[0m\033[?25h\033[?1049l";

std::vector<std::string> drive(const std::vector<std::string>& more) {
  std::vector<std::string> words{"run",  "PidFollower", "--map", "oval",  "--robot",
                                 "uno5", "--goal",      "none",  "--view"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(CliView, QEndsTheRunAndTheTerminalIsAsItWas) {
  OnTerminal run(drive({"--for", "1h"}), 100, 30);
  ASSERT_TRUE(run.wait_for(kEnter)) << run.seen();
  ASSERT_TRUE(run.wait_for("m/s")) << run.seen();
  EXPECT_TRUE(run.is_raw());
  run.type("q");
  ASSERT_TRUE(run.wait_for(kLeave)) << run.seen();
  EXPECT_TRUE(run.wait_for("interrupted:")) << run.seen();
  EXPECT_EQ(run.finish(), 130);
  EXPECT_FALSE(run.is_raw());
}

TEST(CliView, CtrlCDoesTheSame) {
  OnTerminal run(drive({"--for", "1h"}), 100, 30);
  ASSERT_TRUE(run.wait_for("m/s")) << run.seen();
  run.type("\003");
  ASSERT_TRUE(run.wait_for(kLeave)) << run.seen();
  EXPECT_TRUE(run.wait_for("interrupted:")) << run.seen();
  EXPECT_EQ(run.finish(), 130);
  EXPECT_FALSE(run.is_raw());
}

TEST(CliView, SigtermRestoresTheTerminalToo) {
  OnTerminal run(drive({"--for", "1h"}), 100, 30);
  ASSERT_TRUE(run.wait_for("m/s")) << run.seen();
  run.signal(SIGTERM);
  ASSERT_TRUE(run.wait_for(kLeave)) << run.seen();
  EXPECT_EQ(run.finish(), 128 + SIGTERM);
  EXPECT_FALSE(run.is_raw());
}

TEST(CliView, AtTheEndTheVerdictWaitsForAKey) {
  OnTerminal run(drive({"--for", "2s", "--speed", "0"}), 100, 30);
  ASSERT_TRUE(run.wait_for("press any key")) << run.seen();
  run.type("x");
  ASSERT_TRUE(run.wait_for(kLeave)) << run.seen();
  EXPECT_TRUE(run.wait_for("cross-track")) << run.seen();
  EXPECT_EQ(run.finish(), 0);
}

TEST(CliView, FollowsAResizedWindow) {
  OnTerminal run(drive({"--for", "1h"}), 100, 30);
  ASSERT_TRUE(run.wait_for("q end the run")) << run.seen();
  run.resize(60, 20);
  ASSERT_TRUE(run.wait_for("\033[2J")) << run.seen();
  EXPECT_TRUE(run.wait_for("\033[20;1H")) << "the line of keys moves to the new last row\n" << run.seen();
  run.type("q");
  EXPECT_EQ(run.finish(), 130);
}

TEST(CliView, PauseStopsTimeAndSpaceGoesOn) {
  OnTerminal run(drive({"--for", "1h"}), 100, 30);
  ASSERT_TRUE(run.wait_for("m/s")) << run.seen();
  run.type(" ");
  ASSERT_TRUE(run.wait_for("paused")) << run.seen();
  run.type("q");
  ASSERT_TRUE(run.wait_for(kLeave)) << "the view ends while the run is paused\n" << run.seen();
  EXPECT_EQ(run.finish(), 130);
}

TEST(CliRun, CtrlCWithoutAViewEndsTheRunWithItsResult) {
  // The progress line on the terminal shows that the run has begun.
  OnTerminal run(
      {"run", "PidFollower", "--map", "oval", "--robot", "uno5", "--goal", "none", "--for", "1000h"}, 100,
      30);
  ASSERT_TRUE(run.wait_for("simulated: ")) << run.seen();
  run.type("\003");
  EXPECT_TRUE(run.wait_for("interrupted:")) << run.seen();
  EXPECT_EQ(run.finish(), 130);
}

}  // namespace cli_view_test
}  // namespace robosim::test
