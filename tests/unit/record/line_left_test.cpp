// When the line was left, and which sensor saw it last.
#include "sim/record/line_left.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace robosim::record {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> events_of(const std::vector<SensorReadings>& sensors, bool light_line = false) {
  std::vector<double> t_us;
  for (std::size_t i = 0; i < sensors.front().values.size(); ++i)
    t_us.push_back(10'000.0 * static_cast<double>(i));
  std::vector<std::string> texts;
  for (const LineEvent& event : line_events(t_us, sensors, light_line))
    texts.push_back((event.left ? "left " : "found ") + event.sensor + " " + std::to_string(event.t_us));
  return texts;
}

TEST(LineLeft, IsWhereASensorSawItLastAndFoundWhereOneSeesItAgain) {
  EXPECT_THAT(events_of({{"S1", {0.1, 0.9, 0.5, 0.1, 0.1, 0.1, 0.1, 0.1}},
                         {"S2", {0.9, 0.2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.6}}}),
              ElementsAre("left S1 20000", "found S2 70000"));
}

TEST(LineLeft, AGapThatIsJustCrossedIsNotLeft) {
  EXPECT_THAT(events_of({{"S1", {0.9, 0.0, 0.9, 0.0, 0.9}}}), IsEmpty());
}

TEST(LineLeft, ASensorThatIsOverTheLineAllTheTimeSeesItAndOneThatNeverIsDoesNot) {
  EXPECT_THAT(events_of({{"S1", {0.9, 0.9, 0.9, 0.9, 0.9}}, {"S2", {0.9, 0.0, 0.0, 0.0, 0.0}}}), IsEmpty());
  EXPECT_THAT(events_of({{"S1", {0.1, 0.1, 0.1, 0.1, 0.1}}, {"S2", {0.9, 0.0, 0.0, 0.0, 0.0}}}),
              ElementsAre("left S2 0"));
}

TEST(LineLeft, ALightLineIsWhereTheReadingIsLow) {
  EXPECT_THAT(events_of({{"S1", {0.1, 0.9, 0.9, 0.9, 0.9}}}, true), ElementsAre("left S1 0"));
}

}  // namespace
}  // namespace robosim::record
