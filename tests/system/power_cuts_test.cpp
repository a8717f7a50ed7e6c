// Tests that AiNavigator, which stores its map in EEPROM, survives a power cut at every point of a write. It
// must restart with the right map or without a map, and never with a wrong map.
#include "sim/launch/client/power_cuts.h"

#include <cmath>

#include "sim/map/true_graph.h"
#include "tests/system/system_test.h"

namespace robosim::test {
namespace power_cuts_test {

using testing::AnyOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

// Scans and drives to station 2. After the power cut, the robot is sent to station 2 again if it knows the
// way. Otherwise it scans from its current position.
constexpr char kScript[] =
    "at 300ms press start 100ms\n"
    "after serial \"at 1\\r\\n\" send \"2\\n\"\n"
    "after boot 2 wait 300ms send \"2\\n\"\n"
    "after boot 2 wait 1s press start 100ms\n"
    "after boot 2 wait 55s send \"2\\n\"\n";

std::string without_cr(std::string text) {
  std::erase(text, '\r');
  return text;
}

// Returns the first line with this beginning, or an empty text.
std::string line_of(const std::string& text, const std::string& beginning) {
  const std::size_t at = text.find(beginning);
  return at == std::string::npos ? "" : text.substr(at, text.find('\n', at) - at);
}

TEST(AiNavigatorsMap, IsRightOrMissingWhereverThePowerFailsWhileItIsWritten) {
  if (kSlow) GTEST_SKIP() << "too slow for this build; AiNavigatorsMemory tests the same guarantee";
  const test::Run plan{
      .sketch = "AiNavigator", .map = "a", .goal = "none", .script = kScript, .for_s = 120.0};
  const map::Map map = map::read_map(map::find_map(plan.map));
  const map::TrueGraph graph = map::true_graph(map, map::default_start(map));
  const Vec2 station_2 = map.centre(graph.stations[1].cell) * 1e3;
  const std::string counts = std::to_string(graph.stations.size()) + " stations, " +
                             std::to_string(graph.junctions.size()) + " junctions";
  std::string way;  // the route from station 1 to station 2, as the sketch prints it
  int kept = 0, lost = 0;

  // The number of bytes that are written for the map, without the three bytes of the robot's place.
  const std::uint64_t record = run({.sketch = "AiNavigator",
                                    .map = plan.map,
                                    .goal = "none",
                                    .script = "at 300ms press start 100ms\n",
                                    .for_s = 60.0})
                                   .eeprom_writes -
                               3;
  std::size_t runs = 0;
  const auto check = [&](const client::PowerCut& cut, const client::Answer& answer) {
    ++runs;
    SCOPED_TRACE(cut.text());
    const auto* const result = std::get_if<result::RunResult>(&answer);
    ASSERT_TRUE(result) << std::get<client::Failure>(answer).message;
    const std::string all = without_cr(result->serial);
    const std::string text = all.substr(all.rfind("ready\n"));
    SCOPED_TRACE(text);
    ASSERT_NE(all.rfind("ready\n"), 0u) << "the sketch has not started again";
    EXPECT_THAT(text, EndsWith("arrived at 2\ndestination?\n"));
    const bool whole_record = cut.write > record || (cut.write == record && cut.byte == "new");
    if (!whole_record) {
      EXPECT_THAT(text, Not(HasSubstr("I have a map")));
    }
    if (const std::string stored = line_of(text, "I have a map: "); !stored.empty()) {
      EXPECT_EQ(stored, "I have a map: " + counts);
    }
    if (const std::string scanned = line_of(text, "scan complete: "); !scanned.empty()) {
      ++lost;
      EXPECT_THAT(scanned, HasSubstr(counts));
      return;
    }
    ++kept;
    EXPECT_THAT(line_of(text, "way:"), AnyOf(way, "way: station 2"));
    EXPECT_LT(std::hypot(result->end.x_mm - station_2.x, result->end.y_mm - station_2.y), 25.0);
  };

  client::Pool pool(2);
  client::Task task{"host", request_of(plan)};
  way = [&] {
    const result::RunResult whole = run(plan);
    return line_of(without_cr(whole.serial), "way:");
  }();
  EXPECT_THAT(way, HasSubstr("station 2"));
  const client::Answer whole = run_with_power_cuts(pool, task, check);
  ASSERT_TRUE(std::holds_alternative<result::RunResult>(whole));
  EXPECT_EQ(runs, 3 * std::get<result::RunResult>(whole).eeprom_writes);
  EXPECT_GT(runs, 30u);
  EXPECT_GT(kept, 0);
  EXPECT_GT(lost, kept);
}

}  // namespace power_cuts_test
}  // namespace robosim::test
