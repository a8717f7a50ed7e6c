// Tests both versions of the Pro Mini on the host. They differ only in clock and supply voltage, which are
// data of the board.
#include "tests/support/clock_sketch.h"
#include "tests/unit/exec/fixture.h"

namespace robosim::exec {
namespace pro_mini_test {

class ProMini : public HostTest {
 protected:
  test::ReadTimes run_sketch_on(const test::ClockedBoard& clocked) {
    board_name_ = clocked.name;
    serial_.clear();
    pins_.clear();
    start(test::kClockSketch);
    FixedSource half(clocked.supply_volts / 2);
    board().connect(21, half);
    run(kSecond);
    const test::ReadTimes times = test::expect_clock(clocked, numbers(), changes(12));
    EXPECT_NEAR(times.ten_analog_us, test::kTenReads_us, 20);
    return times;
  }
};

TEST_F(ProMini, KeepsTimeAtItsClockAndMeasuresByItsSupply) {
  const test::ReadTimes at_8 = run_sketch_on(test::kProMinis[0]);
  test::expect_twice_the_time(at_8, run_sketch_on(test::kProMinis[1]));
}

}  // namespace pro_mini_test
}  // namespace robosim::exec
