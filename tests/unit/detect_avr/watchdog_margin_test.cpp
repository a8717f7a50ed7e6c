// Tests the detection of a watchdog that is fed with too little margin
// (sim/detect/avr/watchdog_margin.h).

#include "tests/unit/detect_avr/fixture.h"

namespace robosim::detect::watchdog_margin_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class WatchdogMarginTest : public AvrDetectorTest {
 protected:
  std::vector<Detected> seen(const std::string& pass) {
    return found_in(
        "#include <avr/wdt.h>\nvoid setup() { wdt_enable(WDTO_250MS); }\nvoid loop() { wdt_reset(); " + pass +
            " }\n",
        kSecond);
  }
};

TEST_F(WatchdogMarginTest, IsSmallWhereAPassTakesNearlyAsLong) {
  const auto found = seen("static int pass; delay(++pass == 3 ? 235 : 20);");
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].detector, "watchdog_margin");
  EXPECT_THAT(
      found[0].what,
      HasSubstr("with a timeout of 256 ms, was reset 235 ms after the previous reset, 92 % of the timeout"));
  EXPECT_THAT(found[0].mend, HasSubstr("wdt_enable(WDTO_500MS)"));
  EXPECT_EQ(found[0].where.file, "Test.ino");
  EXPECT_EQ(found[0].where.line, 3);
}

TEST_F(WatchdogMarginTest, HasNoLongerTimeoutThanEightSeconds) {
  const auto found = found_in(
      "#include <avr/wdt.h>\nvoid setup() { wdt_enable(WDTO_8S); }\n"
      "void loop() { wdt_reset(); delay(7500); }\n",
      16 * kSecond);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].mend, "Call wdt_reset() within the code that takes so long.");
}

TEST_F(WatchdogMarginTest, IsEnoughWithAFifthToSpareOrWhileItIsOff) {
  EXPECT_THAT(seen("delay(195);"), IsEmpty());
  EXPECT_THAT(seen("wdt_disable(); delay(235); wdt_enable(WDTO_250MS);"), IsEmpty());
}

TEST_F(WatchdogMarginTest, IsOverrunWhereItBites) {
  const auto found = seen("static int pass; delay(++pass == 15 ? 300 : 20);");
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].detector, "watchdog_bite");
  EXPECT_THAT(found[0].what,
              HasSubstr("reset the chip, because wdt_reset() was not called within the timeout of 256 ms"));
  EXPECT_THAT(found[0].mend, HasSubstr("Use a longer timeout, or"))
      << "the time that the code needs is unknown";
  EXPECT_EQ(found[0].where.file, "Test.ino");
  EXPECT_EQ(found[0].where.line, 3);
  EXPECT_EQ(found[0].times, 1);
}

TEST_F(WatchdogMarginTest, IsNoneWhereTheSketchResetsItselfByIt) {
  EXPECT_THAT(seen("delay(700); wdt_enable(WDTO_15MS); while (true) {}"), IsEmpty());
}

}  // namespace robosim::detect::watchdog_margin_test
