// The Pro Minis in the emulator: their clock and their supply are all that is different, and come from data.
#include "tests/support/clock_sketch.h"
#include "tests/unit/exec_avr/fixture.h"

namespace robosim::exec {
namespace {

class ProMini : public AvrTest {
 protected:
  /// Runs the sketch, half the supply on A7; microseconds of a thousand digitalRead().
  double thousand_reads(const test::ClockedBoard& clocked) {
    board_name_ = clocked.name;
    start(test::kClockSketch);
    FixedSource half(clocked.supply_volts / 2);
    board().connect(21, half);
    run(kSecond);
    const auto shown = numbers();
    const auto edges = changes(12);
    EXPECT_EQ(shown.size(), 5u) << serial_;
    EXPECT_EQ(edges.size(), 5u);
    if (shown.size() != 5 || edges.size() != 5) return 0.0;
    EXPECT_NEAR(static_cast<double>(edges[2] - edges[1]), 100e6, 0.05e6);
    EXPECT_NEAR(static_cast<double>(edges[4] - edges[3]), test::kTenBytes_ns, 0.05e6);
    EXPECT_EQ(shown[1], clocked.mhz);
    EXPECT_EQ(shown[2], 512);
    // libsimavr begins a conversion at once, the chip at the next clock of its ADC: 13 or 14 clocks each.
    EXPECT_LE(shown[3], test::kTenReads_us);
    EXPECT_GE(static_cast<double>(shown[3]), test::kTenReads_us * 13 / 14);
    return static_cast<double>(shown[4]);
  }
};

TEST_F(ProMini, KeepsTimeAtItsClockAndMeasuresByItsSupply) {
  const double at_8 = thousand_reads(test::kProMinis[0]);
  const double at_16 = thousand_reads(test::kProMinis[1]);
  EXPECT_NEAR(at_8 / at_16, 2.0, 0.01) << "half the clock, twice the time";
}

}  // namespace
}  // namespace robosim::exec
