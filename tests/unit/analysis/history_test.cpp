#include "sim/campaign/analysis/history.h"

#include <gmock/gmock.h>

namespace robosim::analysis {
namespace history_test {

using testing::ElementsAre;

wire::Sample sample(std::int64_t ms, double left, double right, double x_mm = 0.0) {
  wire::Sample s;
  s.t_us = ms * 1000;
  s.left = left;
  s.right = right;
  s.x_mm = x_mm;
  return s;
}

std::vector<std::string> texts(const std::vector<TimedText>& timed) {
  std::vector<std::string> all;
  for (const TimedText& text : timed) all.push_back(text.text);
  return all;
}

TEST(HistoryTest, TwoWheelsTogetherAreAManoeuvre) {
  EXPECT_EQ(manoeuvre_of(0.0, 0.01), Manoeuvre::stands);
  EXPECT_EQ(manoeuvre_of(0.5, 0.4), Manoeuvre::ahead);
  EXPECT_EQ(manoeuvre_of(-0.5, -0.4), Manoeuvre::back);
  EXPECT_EQ(manoeuvre_of(-0.3, 0.3), Manoeuvre::turns_left);
  EXPECT_EQ(manoeuvre_of(0.3, -0.3), Manoeuvre::turns_right);
  EXPECT_EQ(manoeuvre_of(0.5, 0.0), Manoeuvre::ahead) << "a bend, not a turn";
}

TEST(HistoryTest, AStretchLastsAsLongAsItsManoeuvreAndKeepsTheMeanCommand) {
  HistoryRecorder recorder("host", {});
  recorder.add(wire::Event(sample(0, 0.0, 0.0)));
  recorder.add(wire::Event(sample(10, 0.4, 0.4)));
  recorder.add(wire::Event(sample(20, 0.6, 0.6)));
  recorder.add(wire::Event(sample(30, -0.5, 0.5)));
  const History history = recorder.finish({});
  ASSERT_EQ(history.stretches.size(), 3u);
  EXPECT_EQ(history.stretches[1].manoeuvre, Manoeuvre::ahead);
  EXPECT_EQ(history.stretches[1].duration_ns(), 20'000'000);
  EXPECT_DOUBLE_EQ(history.stretches[1].left, 0.5);
}

TEST(HistoryTest, PlacesAreToldOnceInARowAndNothingAfterTheLineWasLost) {
  HistoryRecorder recorder("host", [](const wire::Sample& s) {
    return s.x_mm < 100 ? std::string("station 1") : s.x_mm < 200 ? std::string() : std::string(kOffTheLine);
  });
  for (const double x : {10.0, 20.0, 150.0, 30.0, 250.0, 20.0})
    recorder.add(wire::Event(sample(static_cast<std::int64_t>(x), 0.5, 0.5, x)));
  const History history = recorder.finish({});
  EXPECT_THAT(texts(history.places), ElementsAre("station 1", kOffTheLine));
  EXPECT_TRUE(history.lost_ns);
}

TEST(HistoryTest, ALineThatTheEndOfTheRunCutsOffIsNotALine) {
  for (const auto& [end_s, lines] : {std::pair{2.05, 1}, std::pair{2.15, 2}}) {
    HistoryRecorder recorder("host", {});
    recorder.add(wire::Event(wire::SerialText{.t_ns = 2'000'000'000, .text = "one\nready>"}));
    result::RunResult result;
    result.time_s = end_s;
    EXPECT_EQ(recorder.finish(result).lines.size(), static_cast<std::size_t>(lines))
        << "a prompt is a line unless the run ends right after it";
  }
}

TEST(HistoryTest, LinesEndAtLineFeedsOrCarriageReturnsAndTheLastMayBeUnfinished) {
  HistoryRecorder recorder("host", {});
  result::RunResult result;
  result.time_s = 1.0;
  recorder.add(wire::Event(wire::SerialText{.t_ns = 1, .text = "one\r\ntw"}));
  recorder.add(wire::Event(wire::SerialText{.t_ns = 2, .text = "o\nthr"}));
  const History history = recorder.finish(result);
  EXPECT_THAT(texts(history.lines), ElementsAre("one", "two", "thr"));
  EXPECT_EQ(history.lines[1].t_ns, 2) << "the time at which the line was complete";
}

}  // namespace history_test
}  // namespace robosim::analysis
