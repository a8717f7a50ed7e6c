// Tests the detection of a stack that overflows only if an interrupt comes at the wrong moment
// (sim/detect/avr/stack_margin.h).

#include "tests/unit/detect_avr/fixture.h"

namespace robosim::detect::stack_margin_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class StackMarginTest : public AvrDetectorTest {
 protected:
  /// Returns the findings for a sketch whose variables take slightly more than `taken` bytes. When loop()'s
  /// stack is deepest, 1832 - `taken` bytes of RAM are free. The stack is that deep for about 10 µs in each
  /// 5 ms. Timer 2's handler uses 108 bytes of stack. It runs once per ms, but not during these 10 µs.
  std::vector<Detected> seen(int taken, const std::string& loop = "deep();", const char* attribute = "") {
    start("volatile byte all[" + std::to_string(taken) + "], sum;\nISR(TIMER2_COMPA_vect" + attribute +
          ") {\n"
          "  volatile byte own[100]; own[0] = sum; all[0] = own[0];\n"
          "}\n"
          "__attribute__((noinline)) void deep() {\n"  // line 5
          "  volatile byte line[200]; line[0] = all[1]; sum = line[0];\n"
          "  if (all[2]) _delay_us(1500);\n"
          "}\n"
          "int recurse(int n) { if (n > 0) sum = n + recurse(n - 1); return sum; }\n"
          "void setup() { TCCR2A = 2; TCCR2B = 4; OCR2A = 249; TIMSK2 = 2; }\n"
          "void loop() { " +
          loop + " delay(5); }\n");
    run(100 * kMillisecond);
    EXPECT_FALSE(avr_->crash()) << avr_->crash()->reason;
    return avr_->detected();
  }
};

TEST_F(StackMarginTest, IsNoneWhereAHandlerThatCameElsewhereWouldOverwriteVariables) {
  const auto found = seen(1750);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].detector, "stack_margin");
  EXPECT_EQ(found[0].what,
            "an interrupt at the wrong moment occasionally overwrites 26 bytes of variables: the handler at "
            "Test.ino:2 takes 108 bytes of stack, and only 82 bytes are free where the main program is "
            "deepest");
  EXPECT_EQ(found[0].where.function, "deep");
  EXPECT_EQ(found[0].where.file, "Test.ino");
  EXPECT_EQ(found[0].where.line, 5);
}

TEST_F(StackMarginTest, IsSmallWhereOneCallMoreWouldDo) {
  const auto found = seen(1720);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(found[0].what, HasSubstr("leaves 4 bytes of RAM"));
}

TEST_F(StackMarginTest, IsNoneWhereTheMainProgramIsDeepBehindADeeperHandler) {
  const auto found =
      seen(1885, "if (all[3] < 4) ++all[3]; else { while (TCNT2 < 240); while (TCNT2 > 9); recurse(12); }");
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(found[0].what, HasSubstr("overwrites"));
  EXPECT_EQ(found[0].where.function, "recurse");
}

TEST_F(StackMarginTest, CountsTheDeepestOtherHandlerToOneThatEnablesInterrupts) {
  const auto found = seen(1700, "deep();", ", ISR_NOBLOCK");
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(found[0].what, HasSubstr("and within it the core's handler __vector_16, in wiring.c takes"));
}

TEST_F(StackMarginTest, IsThereWhereTheDeepestHandlerFits) {
  EXPECT_THAT(seen(1700), IsEmpty());
  EXPECT_THAT(seen(1750, "noInterrupts(); deep(); interrupts();"), IsEmpty()) << "no handler runs in deep()";
  EXPECT_THAT(seen(1750, "TIMSK2 = 0; deep(); TIMSK2 = 2;"), IsEmpty())
      << "only the handler of millis() runs in deep()";
  EXPECT_THAT(seen(1700, "all[2] = 1; deep();"), IsEmpty()) << "the handler runs in deep() and elsewhere";
  EXPECT_THAT(seen(1600, "volatile byte more[100]; more[0] = 1; deep();"), IsEmpty())
      << "after the write of its high byte, the stack pointer is too low for a moment";
}

TEST_F(StackMarginTest, IsTheHeapsWhereThatIsNext) {
  const auto found = seen(1500, "static String text; if (!text.length()) text.reserve(246); deep();");
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(found[0].what, HasSubstr("bytes of the heap"));
}

TEST_F(StackMarginTest, IsNotKnownOfSketchesWithStacksOfTheirOwn) {
  EXPECT_THAT(seen(1750,
                   "static byte other[60]; deep(); uint16_t kept = SP; SP = (uint16_t)other + 50; "
                   "asm volatile(\"nop\"); SP = kept;"),
              IsEmpty());
}

}  // namespace robosim::detect::stack_margin_test
