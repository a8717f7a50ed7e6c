#include "sim/record/record_trace.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "sim/base/file.h"
#include "sim/wire/run_columns.h"
#include "tests/support/temporary_folder.h"

namespace robosim::record {
namespace record_trace_test {

using Json = nlohmann::json;

// Returns the events of a trace in which `key` has the value `value`.
std::vector<Json> those(const Json& trace, const std::string& key, const Json& value) {
  std::vector<Json> found;
  for (const Json& event : trace["traceEvents"])
    if (event.contains(key) && event[key] == value) found.push_back(event);
  return found;
}

class ATrace : public ::testing::Test {
 protected:
  ATrace() {
    result.verdict = "lost";
    result.why = "no line";
    result.time_s = 2.0;
    run.sketch = "My \"Sketch\"";
    run.robot_info.board.name = "uno";
    gatherer.begin(run);
    wire::Started started;
    started.readings = {"S1"};
    gatherer.add(started);
    columns.begin(started.readings);
  }
  Json written() {
    gatherer.add(columns.take());
    write_trace(Recording::decode(gatherer.encoded(result), "x.rec"), file);
    return Json::parse(read_file(file));
  }

  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "run.perfetto.json";
  RecordedRun run;
  result::RunResult result;
  Gatherer gatherer;
  wire::RunColumns columns{{"D5", "A0"}};
};

TEST_F(ATrace, HasASignalsValueWhereItChanges) {
  for (const auto& [t_us, speed] : {std::pair{0, 0.0}, {10'000, 120.5}, {20'000, 120.5}, {30'000, 90.0}})
    columns.add(wire::Sample{t_us, 0, 0, -1.0203, speed, 0, 0, 0, {0.25}, "", {}});
  const Json trace = written();
  EXPECT_EQ(those(trace, "name", "yaw, rad").at(0)["args"]["value"], -1.0203);
  const auto speeds = those(trace, "name", "speed, mm/s");
  ASSERT_EQ(speeds.size(), 3u);
  EXPECT_EQ(speeds[1]["ts"], 10'000.0);
  EXPECT_EQ(speeds[1]["args"]["value"], 120.5);
  EXPECT_EQ(speeds[2]["ts"], 30'000.0);
}

TEST_F(ATrace, HasABarForAPinThatIsHighOrPulses) {
  columns.add_pin(0, 1'000'000, wire::PinLevel::low, 0.0, 0);
  columns.add_pin(0, 2'000'500, wire::PinLevel::high, 1.0, 0);
  columns.add_pin(0, 3'000'000, wire::PinLevel::pulsing, 0.25, 0);
  const auto bars = those(written(), "ph", "X");
  ASSERT_EQ(bars.size(), 2u);
  EXPECT_EQ(bars[0]["name"], "high");
  EXPECT_EQ(bars[0]["ts"], 2000.5) << "microseconds";
  EXPECT_EQ(bars[0]["dur"], 999.5);
  EXPECT_EQ(bars[1]["name"], "PWM 25 %");
  EXPECT_EQ(bars[1]["dur"], 2e6 - 3000.0) << "the pulses last until the run's end";
}

TEST_F(ATrace, HasWhatHappenedAndWhatWasSent) {
  gatherer.add(wire::note_of({1'000'000'000, 0, result::CollisionBegan{}}));
  gatherer.add(wire::SerialText{1'500'000'000, "say \"hi\"\r\n"});
  const auto moments = those(written(), "ph", "i");
  ASSERT_EQ(moments.size(), 3u);
  EXPECT_EQ(moments[0]["ts"], 1e6);
  EXPECT_EQ(moments[1]["name"], "say \"hi\"");
  EXPECT_EQ(moments[2]["name"], "lost: no line");
}

TEST_F(ATrace, ThatIsWrittenWhileTheRunGoesOnTellsTheSame) {
  const auto beside = file.string() + ".beside.perfetto.json";
  TraceRecorder recorder(beside);
  recorder.begin(run);
  std::vector<wire::Event> events{gatherer.header().started};
  for (int i = 0; i < 50; ++i) {
    columns.add(wire::Sample{i * 10'000, -0.01 * i, 0, 0, 0, 0.0001 * i, 0, 0, {0.25}, "", {}});
    columns.add_pin(0, i * 1'000'500, i % 2 == 0 ? wire::PinLevel::high : wire::PinLevel::pulsing, 0.5, 0);
    columns.add_volts(1, i * 333'333, 0.001 * (i % 3));
    if (i % 20 == 0) events.emplace_back(columns.take());
  }
  events.emplace_back(columns.take());
  events.emplace_back(wire::SerialText{1'500'000'000, "hello\n"});
  for (const wire::Event& event : events) {
    gatherer.add(event);
    recorder.add(event);
  }
  recorder.finish(result);
  const auto sorted = [](const Json& trace) {
    std::vector<std::string> lines;
    for (const Json& event : trace["traceEvents"]) lines.push_back(event.dump());
    std::sort(lines.begin(), lines.end());
    return lines;
  };
  const auto lines = sorted(Json::parse(read_file(beside)));
  std::filesystem::remove(beside);
  EXPECT_EQ(lines, sorted(written()));
  EXPECT_GT(lines.size(), 150u);
}

}  // namespace record_trace_test
}  // namespace robosim::record
