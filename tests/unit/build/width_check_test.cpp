#include "sim/build/width_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/build/fixture.h"

namespace robosim::build {
namespace width_check_test {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class WidthCheckTest : public SketchTest {
 protected:
  /// Returns the messages of a build for target host.
  std::string on(const char* board, const std::string& code, Warnings warnings = Warnings::standard) const {
    write("My/My.ino", code + "\nvoid loop() {}\n");
    return build({folder_ / "My", *find_board(board), "host", {}, warnings}).messages;
  }
  std::string in_setup(const std::string& code) const { return on("uno", "void setup() {\n" + code + "\n}"); }
};

TEST_F(WidthCheckTest, AHostBuildNamesWhatOnlyA16BitIntOverflows) {
  EXPECT_THAT(in_setup("delay(4 * 10000);"),
              AllOf(StartsWith("My.ino:2:"), HasSubstr("integer overflow in expression"),
                    HasSubstr(" on the uno, whose int has 16 bits [-Woverflow]\n delay(4 * 10000);\n")));
  EXPECT_THAT(in_setup("unsigned long hour = 60 * 60 * 1000; delay(hour);"),
              AllOf(StartsWith("My.ino:2:"), HasSubstr("whose int has 16 bits")));
  EXPECT_THAT(in_setup("long mask = 1 << 20; delay(mask);"),
              HasSubstr("left shift count >= width of type on the uno"));
  EXPECT_THAT(in_setup("int limit = 100000; delay(limit);"),
              AllOf(HasSubstr("overflow in "), HasSubstr("on the uno, whose int has 16 bits")));
  EXPECT_THAT(on("mega", "void setup() { delay(4 * 10000); }"),
              HasSubstr("on the mega, whose int has 16 bits"));
}

TEST_F(WidthCheckTest, WhatFitsIsNotNamed) {
  EXPECT_EQ(in_setup("delay(4 * 10000L); delay(40000); delay(4UL * 10000);"), "");
  EXPECT_EQ(in_setup("long mask = 1L << 20; delay(mask); int limit = 10000; delay(limit);"), "");
  EXPECT_EQ(in_setup("unsigned int sum = 30000U + 30000U; delay(sum);"), "");
  EXPECT_EQ(on("bluepill", "void setup() { delay(4 * 10000); }"), "") << "a Blue Pill's int has 32 bits";
  EXPECT_EQ(on("uno", "void setup() { delay(4 * 10000); }", Warnings::none), "");
}

TEST_F(WidthCheckTest, WhatTheHostsCompilerNamesIsNotNamedTwice) {
  const std::string messages = in_setup("byte b = 300; delay(b);");
  EXPECT_THAT(messages, AllOf(HasSubstr("My.ino:2:"), Not(HasSubstr("on the uno"))));
}

TEST_F(WidthCheckTest, ErrorsAndOtherWarningsOfTheAvrCompilerDoNotCount) {
  EXPECT_EQ(in_setup("#ifdef ROBOSIM\n#else\n#error \"for Robosim only\"\n#endif\nint x; x = x;"), "");
  EXPECT_THAT(in_setup("#ifndef ROBOSIM\nnot C++ at all;\n#endif\ndelay(4 * 10000);"),
              AllOf(HasSubstr("My.ino:5:"), Not(HasSubstr("error"))));
}

TEST_F(WidthCheckTest, AllSourcesOfASketchAreCheckedButNoLibraryOrCore) {
  write("My/wait.h", "const long kWait = 60 * 1000;\n");
  write("My/wait.cpp", "#include <Arduino.h>\nvoid rest() { delay(5 * 10000); }\n");
  write("libraries/Slow/Slow.h", "const long kSlow = 70 * 1000;\n");
  write("My/My.ino",
        "#include <Slow.h>\n#include \"wait.h\"\nvoid rest();\n"
        "void setup() { rest(); delay(kWait + kSlow); }\nvoid loop() {}\n");
  const std::string messages = build_here("My", {folder_ / "libraries"}).messages;
  EXPECT_THAT(messages, AllOf(HasSubstr("wait.h:1:"), HasSubstr("wait.cpp:2:"), Not(HasSubstr("Slow.h"))));
}

TEST_F(WidthCheckTest, TheWarningComesFromTheCacheAgain) {
  write("My/wait.cpp", "#include <Arduino.h>\nvoid rest() { delay(5 * 10000); }\n");
  const std::string code = "void rest();\nvoid setup() { rest(); }";
  const std::string messages = on("uno", code);
  EXPECT_THAT(messages, StartsWith("wait.cpp:2:"));
  const Image again = build_here("My");
  EXPECT_TRUE(again.from_cache);
  EXPECT_EQ(again.messages, messages);
  EXPECT_EQ(on("uno", code + "\n// changed"), messages) << "the object of wait.cpp is unchanged";
}

TEST_F(WidthCheckTest, WithoutTheAvrCompilerAHostBuildIsAsBefore) {
  const std::filesystem::path tools = folder_ / "tools";
  std::filesystem::create_directories(tools);
  for (const auto& tool : std::filesystem::directory_iterator("/usr/bin"))
    if (!tool.path().filename().string().starts_with("avr-"))
      std::filesystem::create_symlink(tool.path(), tools / tool.path().filename());
  ::setenv("PATH", tools.c_str(), 1);
  EXPECT_EQ(in_setup("delay(4 * 10000);"), "");
}

TEST_F(WidthCheckTest, TheCompilerSeesOnlyTheFilesOfAnUntrustedSketch) {
  write("club/number.h", "4\n");
  write("club/My/My.ino",
        "#ifndef ROBOSIM\nlong product = (\n#include \"../number.h\"\n) * 10000;\n#endif\n" + kEmptySketch);
  Request request{folder_ / "club/My", *find_board("uno")};
  EXPECT_THAT(build(request).messages, StartsWith("My.ino:4:"));
  request.untrusted = true;
  EXPECT_EQ(build(request).messages, "");
  write("club/My/My.ino", "void setup() { delay(4 * 10000); }\nvoid loop() {}\n");
  EXPECT_THAT(build(request).messages, StartsWith("My.ino:1:"));
}

}  // namespace width_check_test
}  // namespace robosim::build
