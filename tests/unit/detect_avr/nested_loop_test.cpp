// Tests the detection of a loop() that calls itself (sim/detect/avr/nested_loop.h).

#include "tests/unit/detect_avr/fixture.h"

namespace robosim::detect::nested_loop_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class NestedLoopTest : public AvrDetectorTest {
 protected:
  std::vector<Detected> seen(const std::string& wait) {
    return found_in(
        "unsigned n;\nvoid setup() { Serial.begin(115200); }\n" + wait +
            "\nvoid loop() {\n  if (millis() / 200 > n) { Serial.println(++n); wait(); }\n  delay(5);\n}\n",
        2 * kSecond);
  }
};

TEST_F(NestedLoopTest, IsToldWhereItDoesNotComeBack) {
  const auto found = seen("void wait() { for (;;) loop(); }");
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].detector, "nested_loop");
  EXPECT_THAT(found[0].what, HasSubstr("are open at"));
  EXPECT_EQ(found[0].where.line, 3);
  EXPECT_GE(found[0].times, 5);
}

TEST_F(NestedLoopTest, IsNoneWhereItComesBack) {
  EXPECT_THAT(seen("byte depth;\nvoid wait() { if (depth == 0) { ++depth; for (int i = 0; i < 9; ++i) "
                   "loop(); --depth; } }"),
              IsEmpty());
  EXPECT_THAT(seen("void wait() { delay(1); }"), IsEmpty());
}

}  // namespace robosim::detect::nested_loop_test
