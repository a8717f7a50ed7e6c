// Tests which compiler warnings about libraries are shown to the user.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/build/fixture.h"

namespace robosim::build {
namespace library_warnings_test {

using ::testing::HasSubstr;
using ::testing::Not;

class LibraryWarnings : public SketchTest {};

TEST_F(LibraryWarnings, AreLeftOutAsNobodyWhoUsesALibraryCanDoAnythingAboutThem) {
  write("My/libraries/Thing/Thing.h", "int thing();\n");
  write("My/libraries/Thing/Thing.cpp",
        "#include \"Thing.h\"\nint thing() { int x = 1; if (x = 2); return 'ab'; }\n");
  write("My/My.ino", "#include <Thing.h>\nint x;\nvoid setup() { if (x = thing()) {} }\nvoid loop() {}\n");
  EXPECT_THAT(build_here("My").messages, Not(HasSubstr("Thing.cpp")));
  EXPECT_THAT(build_here("My").messages, HasSubstr("My.ino:3"));
}

TEST_F(LibraryWarnings, AForgottenBreakIsOneUnlessACommentSaysThatItIsMeant) {
  const std::string sketch =
      "int n;\nvoid setup() { Serial.begin(9600); }\nvoid loop() {\n  switch (n) {\n    case 0: n = 1;%\n"
      "    case 1: case 2: n = 3; break;\n  }\n}\n";
  const auto with = [&](const std::string& comment) {
    std::string text = sketch;
    return text.replace(text.find('%'), 1, comment);
  };
  write("My/My.ino", with(""));
  EXPECT_THAT(build_here("My").messages, HasSubstr("My.ino:5:15: warning: this statement may fall through"));
  write("My/My.ino", with("  // and on"));
  EXPECT_EQ(build_here("My").messages, "");
}

}  // namespace library_warnings_test
}  // namespace robosim::build
