// Tests finding the times at which a robot left the line and returned. Also tests finding the sensor that
// last saw the line.
#include "sim/record/line_left.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace robosim::record {
namespace line_left_test {

using testing::ElementsAre;
using testing::IsEmpty;

struct SensorReadings {
  std::string name;
  std::vector<float> values;
};

std::vector<std::string> events_of(const std::vector<SensorReadings>& sensors, bool light_line = false) {
  std::vector<std::string> names;
  for (const SensorReadings& sensor : sensors) names.push_back(sensor.name);
  LineWatch watch(names, light_line);
  for (std::size_t i = 0; i < sensors.front().values.size(); ++i) {
    std::vector<float> readings;
    for (const SensorReadings& sensor : sensors) readings.push_back(sensor.values[i]);
    watch.add(10'000 * static_cast<std::int64_t>(i), readings);
  }
  std::vector<std::string> texts;
  for (const LineEvent& event : watch.events())
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

}  // namespace line_left_test
}  // namespace robosim::record
