// Tests the two-wire bus from a sketch's Wire to the robot's parts.
#include "tests/system/system_test.h"

namespace robosim::test {
namespace two_wire_test {

class TwoWire : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override { needs_target(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(On, TwoWire, testing::Values("host", "avr"),
                         [](const auto& target) { return std::string(target.param); });

TEST_P(TwoWire, IsSpokenByWireAndAnsweredByThePartsAlone) {
  const result::RunResult r = run({.sketch = "TwoWire",
                                   .robot = std::string(ROBOSIM_TEST_SKETCHES) + "/TwoWire/robot.toml",
                                   .goal = "none",
                                   .for_s = 0.5,
                                   .target = GetParam()});
  EXPECT_EQ(r.verdict, "reached") << r.why;
  EXPECT_EQ(r.serial, "002\r\n0\r\n68\r\n16\r\n");
  EXPECT_THAT(r.usage.unwired, testing::IsEmpty());
}

}  // namespace two_wire_test
}  // namespace robosim::test
