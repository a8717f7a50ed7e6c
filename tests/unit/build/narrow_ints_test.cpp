#include "sim/build/narrow_ints.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/build/fixture.h"

namespace robosim::build {
namespace narrow_ints_test {

using ::testing::HasSubstr;

TEST(NarrowInts, ReplaceTheWordIntAndNothingElse) {
  EXPECT_EQ(with_narrow_ints("unsigned int a[6]; print(int b); long int c; uint8_t d;"),
            "unsigned short a[6]; print(short b); long int c; uint8_t d;");
  EXPECT_EQ(with_narrow_ints("// int\n\"int \\\" int\" /* int */ 'i' int"),
            "// int\n\"int \\\" int\" /* int */ 'i' short");
}

TEST(NarrowInts, AreWantedWhereAnIntGoesToAPointerTo16Bits) {
  EXPECT_TRUE(wants_narrow_ints(
      "a.ino:7:43: error: cannot convert 'int [6]' to 'uint16_t*' {aka 'short unsigned int*'}\n"));
  EXPECT_TRUE(
      wants_narrow_ints("a.ino:7:43: error: cannot convert 'unsigned int*' to 'short unsigned int*'\n"));
  EXPECT_FALSE(wants_narrow_ints("a.ino:7:43: error: cannot convert 'float [6]' to 'uint16_t*'\n"));
  EXPECT_FALSE(wants_narrow_ints("a.ino:7:43: error: cannot convert 'int [6]' to 'uint8_t*'\n"));
}

class NarrowIntsOf : public SketchTest {};

TEST_F(NarrowIntsOf, ASketchAreAWarningOnTheHostAsOnTheChip) {
  write("My/My.ino",
        "int values[6];\nunsigned int others[6];\nvoid fill(uint16_t* v) { v[1] = 7; }\n"
        "int sum(int* v) { return v[0] + v[1]; }\n"
        "void setup() {\n  fill(values);\n  fill(others);\n  Serial.println(sum(values));\n}\nvoid loop() "
        "{}\n");
  const Image image = build_here("My");
  EXPECT_THAT(image.messages, HasSubstr("My.ino:6:"));
  EXPECT_THAT(image.messages, HasSubstr("warning: invalid conversion from 'short"));
}

TEST_F(NarrowIntsOf, AProgramThatTheyDoNotHelpIsToldItsOwnError) {
  write("My/My.ino",
        "int values[6];\nvoid fill(uint16_t*) {}\nvoid setup() { fill(values); gone(); }\nvoid loop() {}\n");
  try {
    build_here("My");
    ADD_FAILURE() << "it compiled";
  } catch (const CompileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("cannot convert 'int"));
  }
}

}  // namespace narrow_ints_test
}  // namespace robosim::build
