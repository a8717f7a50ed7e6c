#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/build/fixture.h"

namespace robosim::build {
namespace {

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

}  // namespace
}  // namespace robosim::build
