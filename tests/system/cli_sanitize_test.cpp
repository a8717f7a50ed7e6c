// `--sanitize`, as a user gives it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/system/command.h"

namespace robosim::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kSpeeds =
    "int speeds[5];\n"
    "int average() {\n"
    "  int sum = 0;\n"
    "  for (int i = 0; i <= 5; i++) sum += speeds[i];\n"
    "  return sum / 5;\n"
    "}\n"
    "void setup() { Serial.begin(9600); }\n"
    "void loop() { Serial.println(average()); }\n";

TEST(CliSanitize, EndsTheRunAtABadIndexAndNamesItsPlace) {
  const Folder folder;
  folder.write("Speeds/Speeds.ino", kSpeeds);
  std::vector<std::string> words = {"run", "Speeds/", "--goal", "none", "--for", "100ms", "--json"};
  const Ended plain = robosim_command(words, folder.path());
  EXPECT_EQ(plain.status, 0) << plain.out << plain.err;
  EXPECT_THAT(plain.out, Not(HasSubstr("sanitize")));
  words.push_back("--sanitize");
  const Ended checked = robosim_command(words, folder.path());
  EXPECT_EQ(checked.status, 1) << checked.err;
  EXPECT_THAT(
      checked.out,
      AllOf(HasSubstr("\"verdict\": \"crashed\""),
            HasSubstr("\"why\": \"The sketch crashed: index 5 is outside of the array, an int [5]: its "
                      "first is 0 and its last 4 in average, Speeds.ino:4.\""),
            HasSubstr("\"function\": \"average\",\n    \"file\": \"Speeds.ino\",\n    \"line\": 4\n"),
            HasSubstr("\"sanitize\": true")));
  EXPECT_EQ(robosim_command(words, folder.path()).out, checked.out) << "the same bytes each time";
}

TEST(CliSanitize, IsRefusedForAChip) {
  for (const char* command : {"run", "build"}) {
    const Ended ended = robosim_command({command, "PidFollower", "--target", "avr", "--sanitize"});
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(ended.err, "robosim: --sanitize is for --target host; a chip has no room for its checks\n");
  }
}

TEST(CliSanitize, OurOwnSketchDrivesWithoutAFinding) {
  const Ended run = robosim_command({"run", "PidFollower", "--map", "oval", "--robot", "uno5", "--sanitize"});
  EXPECT_EQ(run.status, 0) << run.out << run.err;
}

}  // namespace
}  // namespace robosim::test
