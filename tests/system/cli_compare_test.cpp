// `robosim compare`: it finds each planted difference, and none where targets only take their time.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/require_target.h"
#include "tests/system/command.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class CliCompare : public ::testing::Test {
 protected:
  void SetUp() override {
    needs_target("avr");
    if (!IsSkipped() && !HasFatalFailure()) needs_target("stm32");
  }

  /// A planted difference, between two targets.
  Ended compare(const std::string& sketch, const std::string& targets,
                std::vector<std::string> more = {}) const {
    std::vector<std::string> words{"compare",  sketch_folder(sketch).string() + "/",
                                   "--map",    "oval",
                                   "--target", targets,
                                   "--goal",   "none",
                                   "--for",    "4s"};
    words.insert(words.end(), more.begin(), more.end());
    return robosim_command(words);
  }
};

TEST_F(CliCompare, ANumberThatDoesNotFitAnIntIsFoundWithItsLines) {
  const Ended ended = compare("DiffersInWidth", "host,avr");
  EXPECT_EQ(ended.status, 1) << ended.err;
  EXPECT_THAT(ended.out,
              AllOf(HasSubstr("host   says \"path 40000\"\n         DiffersInWidth.ino:7 in report()"),
                    HasSubstr("avr    says \"path -25536\"\n         DiffersInWidth.ino:7 in report()"),
                    HasSubstr("integer width: -25536 = 40000 - 2^16"),
                    HasSubstr("checks    160 * 250 does not fit an int"), HasSubstr("DiffersInWidth.ino:5")))
      << ended.out;
}

TEST_F(CliCompare, ADivisionByZeroIsFound) {
  const Ended ended = compare("DiffersInDivision", "avr,stm32", {"--json"});
  EXPECT_EQ(ended.status, 1) << ended.err;
  const auto json = nlohmann::json::parse(ended.out);
  EXPECT_EQ(json["schema"], "robosim.compare/1");
  const auto& difference = json["difference"];
  EXPECT_EQ(difference["kind"], "number");
  EXPECT_EQ(difference["sides"][0]["text"], "says \"-1\"");
  EXPECT_EQ(difference["sides"][1]["text"], "says \"0\"");
  EXPECT_EQ(difference["sides"][1]["source"]["line"], 9);
  EXPECT_EQ(difference["sides"][0]["finding"]["line"], 4) << ended.out;
}

TEST_F(CliCompare, TheWrapOfMillisIsFound) {
  const Ended ended = compare("DiffersAtWrap", "host,avr", {"--clock", "4294966s"});
  EXPECT_EQ(ended.status, 1) << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("line 2 of the serial port, \"three seconds later\"\n"),
                               HasSubstr("DiffersAtWrap.ino:11 in setup()")))
      << ended.out;
  EXPECT_EQ(compare("DiffersAtWrap", "host,avr").status, 0) << "without --clock nothing wraps";
}

TEST_F(CliCompare, WhatNobodyHasSetIsFound) {
  // On a 32-bit Raspberry Pi the host's stack is laid out as the STM32's.
  const Ended ended = compare("DiffersInGarbage", "avr,stm32");
  EXPECT_EQ(ended.status, 1) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("DiffersInGarbage.ino:9 in printWhatIsThere()")) << ended.out;
}

TEST_F(CliCompare, AWaitThatIsNoTimeIsFound) {
  const Ended ended = compare("DiffersInTime", "avr,stm32");
  EXPECT_EQ(ended.status, 1) << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("line 2 of the serial port, \"waited\"\n"),
                               HasSubstr("DiffersInTime.ino:11 in setup()")))
      << ended.out;
}

TEST_F(CliCompare, OurSketchesDoTheSameOnAllTargets) {
  for (const auto& [sketch, map, robot, length] :
       {std::array{"PidFollower", "oval", "uno5", "3s"}, std::array{"LeftPath", "a", "uno3", "8s"}}) {
    const Ended ended = robosim_command(
        {"compare", sketch, "--map", map, "--robot", robot, "--goal", "none", "--for", length});
    EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
    EXPECT_THAT(ended.out, AllOf(HasSubstr("host, avr and stm32 do the same"), Not(HasSubstr("difference"))));
  }
}

TEST_F(CliCompare, AnUnosRobotIsTakenWithABoardOfEachTarget) {
  const Folder folder;
  ASSERT_EQ(robosim_command({"new", "mine"}, folder.path()).status, 0);
  const Ended ended =
      robosim_command({"compare", "./mine", "--goal", "none", "--for", "2s", "--json"}, folder.path());
  EXPECT_EQ(ended.status, 0) << ended.err;
  const auto runs = nlohmann::json::parse(ended.out)["runs"];
  EXPECT_EQ(runs[0]["robot"], "robot.toml");
  EXPECT_EQ(runs[1]["robot"], "robot.toml");
  EXPECT_EQ(runs[2]["robot"], "robot.toml@bluepill");
}

TEST_F(CliCompare, WhatCannotBeComparedIsSaidInOneSentence) {
  const Ended ended = robosim_command({"compare", "PidFollower", "--target", "host,arduino"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.err, HasSubstr("arduino"));
}

}  // namespace
}  // namespace robosim::test
