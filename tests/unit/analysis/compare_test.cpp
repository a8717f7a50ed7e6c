// Tests compare(), which finds the first difference between two runs. The runs are fictitious.

#include "sim/campaign/analysis/compare.h"

#include <gmock/gmock.h>

namespace robosim::analysis {
namespace compare_test {

using testing::HasSubstr;
using Kind = Difference::Kind;

constexpr std::int64_t kMs = 1'000'000, kS = 1'000'000'000;

/// Returns a run of 20 s whose robot drives ahead all the time.
History run() {
  History h;
  h.verdict = "reached";
  h.end_ns = 20 * kS;
  h.stretches = {{0, 20 * kS, Manoeuvre::ahead, 0.5, 0.5}};
  return h;
}

/// Returns a run whose robot does `manoeuvre` between the times `from` and `to`, and otherwise drives ahead.
History with(Manoeuvre manoeuvre, std::int64_t from, std::int64_t to) {
  History h = run();
  h.stretches = {{0, from, Manoeuvre::ahead, 0.5, 0.5},
                 {from, to, manoeuvre},
                 {to, 20 * kS, Manoeuvre::ahead, 0.5, 0.5}};
  return h;
}

History places(std::vector<TimedText> marks) {
  History h = run();
  h.places = std::move(marks);
  return h;
}

History lines(std::vector<TimedText> marks) {
  History h = run();
  h.lines = std::move(marks);
  return h;
}

std::optional<Kind> kind(const History& a, const History& b) {
  const auto forth = compare(a, b).first, back = compare(b, a).first;
  EXPECT_EQ(forth.has_value(), back.has_value()) << "the order of the two runs does not matter";
  if (!forth) return std::nullopt;
  if (back) {
    EXPECT_EQ(forth->kind, back->kind);
  }
  return forth->kind;
}

TEST(Compare, TheFirstPlaceIsTimedFromTheStart) {
  const auto first = compare(places({{4 * kS, "lap 1"}}), places({{8 * kS, "lap 1"}})).first;
  ASSERT_TRUE(first);
  EXPECT_EQ(first->kind, Kind::time);
  EXPECT_EQ(first->sides[1], "comes 8.000 s after the start");
}

TEST(Compare, TheSameIsNoDifference) { EXPECT_EQ(kind(run(), run()), std::nullopt); }

TEST(Compare, ARobotThatComesALittleLaterIsNoDifference) {
  EXPECT_EQ(kind(places({{0, "station 1"}, {4 * kS, "junction 1"}, {9 * kS, "station 2"}}),
                 places({{0, "station 1"}, {4300 * kMs, "junction 1"}, {9900 * kMs, "station 2"}})),
            std::nullopt);
}

TEST(Compare, AnotherPlaceIsADifferenceAndIsNamed) {
  const History a = places({{0, "station 1"}, {4 * kS, "junction 1"}, {9 * kS, "station 2"}});
  const History b = places({{0, "station 1"}, {4 * kS, "junction 1"}, {9 * kS, "station 3"}});
  EXPECT_EQ(kind(a, b), Kind::place);
  const Difference d = *compare(a, b).first;
  EXPECT_EQ(d.what, "the way after junction 1");
  EXPECT_EQ(d.sides[0], "comes to station 2");
  EXPECT_EQ(d.sides[1], "comes to station 3");
}

TEST(Compare, APlaceThatOnlyOneComesToIsADifferenceIfTheOtherHadTheTime) {
  const History a = places({{0, "station 1"}, {4 * kS, "junction 1"}});
  History b = places({{0, "station 1"}});
  EXPECT_EQ(kind(a, b), Kind::place);
  b.end_ns = 5 * kS;
  EXPECT_EQ(kind(a, b), std::nullopt) << "the second run ended too early";
}

TEST(Compare, AWayThatTakesMuchLongerIsADifferenceOfTime) {
  EXPECT_EQ(kind(places({{0, "station 1"}, {4 * kS, "junction 1"}}),
                 places({{0, "station 1"}, {7 * kS, "junction 1"}})),
            Kind::time);
}

TEST(Compare, LinesAreComparedInTheirOrder) {
  const History a = lines({{kS, "ready"}, {2 * kS, "left"}, {3 * kS, "right"}});
  EXPECT_EQ(kind(a, lines({{kS, "ready"}, {2 * kS, "right"}, {3 * kS, "left"}})), Kind::line);
  EXPECT_EQ(kind(a, lines({{kS, "ready"}, {2 * kS, "left"}})), Kind::line);
  EXPECT_EQ(kind(a, lines({{kS, "ready"}, {2200 * kMs, "left"}, {3100 * kMs, "right"}})), std::nullopt);
}

TEST(Compare, NumbersInALineMayDifferALittle) {
  EXPECT_EQ(kind(lines({{kS, "scanned in 93 s"}}), lines({{kS, "scanned in 95 s"}})), std::nullopt);
  EXPECT_EQ(kind(lines({{kS, "3 stations"}}), lines({{kS, "4 stations"}})), Kind::number);
}

TEST(Compare, WhatDoesNotFitAnIntIsNamed) {
  const auto d = compare(lines({{kS, "sum 40000"}}), lines({{kS, "sum -25536"}})).first;
  ASSERT_TRUE(d);
  EXPECT_THAT(d->cause, HasSubstr("integer width"));
  EXPECT_EQ(d->line[0], 0u);
}

TEST(Compare, FormattingIsKnownAndDoesNotCount) {
  const Comparison c =
      compare(lines({{kS, "pi 3.141593 FFFFFFFFFFFFFFFF"}}), lines({{kS, "pi 3.141592 FFFFFFFF"}}));
  EXPECT_FALSE(c.first);
  ASSERT_EQ(c.known.size(), 2u);
  EXPECT_EQ(c.known[0].what, "float formatting");
  EXPECT_EQ(c.known[1].what, "width of long");
}

/// Returns a run whose sketch prints `offset` plus a triangle wave of 0 to 40, at intervals of `every`.
History stream(std::int64_t every, int offset) {
  History h = run();
  for (std::int64_t t = every; t < h.end_ns; t += every) {
    const auto phase = static_cast<int>(t / (50 * kMs) % 40);
    h.lines.push_back({t, "error " + std::to_string(offset + (phase < 20 ? phase : 40 - phase) * 2)});
  }
  return h;
}

TEST(Compare, AStreamOfReadingsMayShakeAndDriftButNotBeElsewhere) {
  EXPECT_EQ(kind(stream(20 * kMs, 0), stream(22 * kMs, 0)), std::nullopt);
  EXPECT_EQ(kind(stream(20 * kMs, 0), stream(22 * kMs, 500)), Kind::number);
  EXPECT_EQ(kind(stream(20 * kMs, 0), stream(40 * kMs, 0)), Kind::time);
}

TEST(Compare, ALineThatComesFiveTimesInTwoSecondsIsAStreamToo) {
  const auto readings = [](std::vector<int> values, std::int64_t every) {
    History history;
    for (std::size_t i = 0; i < values.size(); ++i)
      history.lines.push_back({static_cast<std::int64_t>(i) * every, "left " + std::to_string(values[i])});
    history.end_ns = 10 * kS;
    return history;
  };
  EXPECT_EQ(
      kind(readings({100, 300, 100, 300, 100}, 400 * kMs), readings({300, 100, 300, 100, 300}, 400 * kMs)),
      std::nullopt);
  EXPECT_EQ(
      kind(readings({100, 300, 100, 300, 100}, 900 * kMs), readings({300, 100, 300, 100, 300}, 900 * kMs)),
      Kind::number);
}

/// Returns a run whose sketch prints the numbers `values`, at intervals of 0.4 s. The number `there` replaces
/// the number at index `odd`.
History readings(std::vector<int> values, std::size_t odd, int there) {
  History h = run();
  values.at(odd) = there;
  for (std::size_t i = 0; i < values.size(); ++i)
    h.lines.push_back({static_cast<std::int64_t>(i + 1) * 400 * kMs, "e " + std::to_string(values[i])});
  return h;
}

TEST(Compare, AReadingThatRangesWidelyMayBeOneBesideButAStateNot) {
  const std::vector<int> wide{0, -22, -6, -6, -6, -6, -6, -6, -6, -6, -6},
      narrow{1, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3};
  EXPECT_EQ(kind(readings(wide, 6, -7), readings(wide, 6, -6)), std::nullopt);
  EXPECT_EQ(kind(readings(wide, 6, -8), readings(wide, 6, -6)), Kind::number);
  EXPECT_EQ(kind(readings(narrow, 6, 4), readings(narrow, 6, 3)), Kind::number);
}

TEST(Compare, TheLineOfAStreamThatIsShownIsTheOneOfThatMoment) {
  std::vector<int> rising;
  for (int i = 0; i < 20; ++i) rising.push_back(1000 * i);
  const auto d = compare(readings(rising, 8, 500), readings(rising, 8, 8000)).first;
  ASSERT_TRUE(d);
  EXPECT_EQ(d->sides[0], "prints \"e 500\"");
  EXPECT_EQ(d->sides[1], "prints \"e 8000\", and nothing closer within a second");
}

/// Returns a run whose sketch prints a line each second: "on" before `off_from`, then "off".
History light(std::int64_t off_from) {
  History h;
  h.end_ns = 70 * kS;
  for (std::int64_t t = 0; t < h.end_ns; t += kS) h.lines.push_back({t, t < off_from ? "on" : "off"});
  return h;
}

TEST(Compare, AStreamMayEndALittleSoonerButNotLongBefore) {
  EXPECT_EQ(kind(light(21 * kS), light(21 * kS)), std::nullopt);
  EXPECT_EQ(kind(light(21 * kS), light(24 * kS)), std::nullopt);
  EXPECT_EQ(kind(light(42 * kS), light(21 * kS)), Kind::time);
  const auto d = compare(light(21 * kS), light(5 * kS)).first;
  ASSERT_TRUE(d);
  EXPECT_EQ(d->kind, Kind::time);
  EXPECT_EQ(d->what, "the line \"off\"");
  EXPECT_EQ(d->t_ns[1], 5 * kS);
  EXPECT_EQ(d->sides[1], "prints it repeatedly");
  EXPECT_EQ(d->sides[0], "does not print it for at least 9.000 s");
}

TEST(Compare, AStreamThatOneSideHadNoTimeForIsNoDifference) {
  History a = light(21 * kS), b = a;
  std::erase_if(b.lines, [](const TimedText& line) { return line.t_ns > 25 * kS; });
  EXPECT_EQ(kind(a, b), Kind::time) << "the second run prints nothing more";
  b.end_ns = 25 * kS;
  EXPECT_EQ(kind(a, b), std::nullopt) << "the second run has ended";
}

TEST(Compare, ALineAmongAStreamIsFoundWhereverItIs) {
  History a = stream(20 * kMs, 0), b = stream(22 * kMs, 0);
  a.lines.insert(a.lines.begin() + 100, {a.lines[100].t_ns, "turning"});
  EXPECT_EQ(kind(a, b), Kind::line);
  b.lines.insert(b.lines.begin() + 95, {b.lines[95].t_ns, "turning"});
  EXPECT_EQ(kind(a, b), std::nullopt);
}

TEST(Compare, AShortManoeuvreOrOneALittleLaterIsNoDifference) {
  EXPECT_EQ(kind(with(Manoeuvre::turns_left, 5 * kS, 5400 * kMs), run()), std::nullopt);
  EXPECT_EQ(
      kind(with(Manoeuvre::turns_left, 5 * kS, 5700 * kMs), with(Manoeuvre::turns_left, 5500 * kMs, 6 * kS)),
      std::nullopt);
}

TEST(Compare, AManoeuvreThatTheOtherDoesNotMakeIsADifference) {
  EXPECT_EQ(kind(with(Manoeuvre::turns_left, 5 * kS, 5700 * kMs), run()), Kind::motors);
  EXPECT_EQ(
      kind(with(Manoeuvre::turns_left, 5 * kS, 5700 * kMs), with(Manoeuvre::turns_right, 5 * kS, 5700 * kMs)),
      Kind::motors);
  EXPECT_EQ(kind(with(Manoeuvre::stands, 5 * kS, 5700 * kMs), with(Manoeuvre::stands, 12 * kS, 12700 * kMs)),
            Kind::motors);
}

TEST(Compare, ManoeuvresAreFoundThoughTheRobotIsLateByMoreThanASecond) {
  History a = with(Manoeuvre::turns_left, 9500 * kMs, 10200 * kMs),
          b = with(Manoeuvre::turns_left, 11500 * kMs, 12200 * kMs);
  EXPECT_EQ(kind(a, b), Kind::motors);
  a.places = {{0, "station 1"}, {5 * kS, "junction 1"}, {9 * kS, "junction 2"}};
  b.places = {{0, "station 1"}, {6 * kS, "junction 1"}, {11 * kS, "junction 2"}};
  EXPECT_EQ(kind(a, b), std::nullopt) << "the robot is late at every place";
}

TEST(Compare, ManoeuvresMayBeFurtherApartTheLongerAgoTheLastCommonEventWas) {
  const auto long_run = [](std::int64_t turns_at) {
    History h = run();
    h.end_ns = 600 * kS;
    h.stretches = {{0, turns_at, Manoeuvre::ahead, 0.5, 0.5},
                   {turns_at, turns_at + 700 * kMs, Manoeuvre::turns_left},
                   {turns_at + 700 * kMs, 600 * kS, Manoeuvre::ahead, 0.5, 0.5}};
    return h;
  };
  EXPECT_EQ(kind(long_run(300 * kS), long_run(303 * kS)), std::nullopt) << "1 % of five minutes is 3 s";
  EXPECT_EQ(kind(long_run(300 * kS), long_run(306 * kS)), Kind::motors);
  History a = long_run(300 * kS), b = long_run(303 * kS);
  a.places = b.places = {{0, "station 1"}, {299 * kS, "junction 1"}};
  EXPECT_EQ(kind(a, b), Kind::motors) << "both robots were at the same place a second before";
}

TEST(Compare, WhatARobotDoesOffTheLineDoesNotCount) {
  History a = places({{0, "station 1"}, {4 * kS, kOffTheLine}}), b = a;
  a.lost_ns = b.lost_ns = 4 * kS;
  b.end_ns = 25 * kS;
  EXPECT_EQ(kind(a, b), std::nullopt);
  b.places.back().t_ns = *b.lost_ns = 9 * kS;
  b.places.insert(b.places.begin() + 1, {6 * kS, "junction 1"});
  EXPECT_EQ(kind(a, b), std::nullopt) << "the time of leaving the line does not matter";
  a.verdict = "lost";
  b.verdict = "stuck";
  EXPECT_EQ(kind(a, b), std::nullopt);
  b.verdict = "crashed";
  EXPECT_EQ(kind(a, b), Kind::verdict);
  b = places({{0, "station 1"}});
  EXPECT_EQ(kind(a, b), Kind::place) << "only the first robot leaves the line";
}

TEST(Compare, MuchSlowerIsADifference) {
  History slow = run();
  slow.stretches = {{0, 20 * kS, Manoeuvre::ahead, 0.2, 0.2}};
  EXPECT_EQ(kind(run(), slow), Kind::speed);
}

TEST(Compare, TheVerdictIsComparedAndTheEarliestDifferenceIsTold) {
  History lost = run();
  lost.verdict = "lost";
  lost.end_ns = 15 * kS;
  EXPECT_EQ(kind(run(), lost), Kind::verdict);
  History a = run();
  a.lines = {{3 * kS, "left"}};
  lost.lines = {{3 * kS, "right"}};
  EXPECT_EQ(kind(a, lost), Kind::line);
}

TEST(Compare, WhatCameTooEarlyOnOneSideIsToldBeforeWhatCameOfIt) {
  History a = with(Manoeuvre::turns_left, 5100 * kMs, 6 * kS);
  a.lines = {{kS, "ready"}, {5 * kS, "go"}};
  History b = with(Manoeuvre::turns_left, 2100 * kMs, 3 * kS);
  b.lines = {{kS, "ready"}, {2 * kS, "go"}};
  EXPECT_EQ(kind(a, b), Kind::time);
}

TEST(HistoryRecorder, MakesManoeuvresPlacesAndLinesOfEvents) {
  HistoryRecorder recorder("host", [](const wire::Sample& s) -> std::string {
    return s.x_mm < 100.0 ? "station 1" : "junction 1";
  });
  for (int i = 0; i <= 100; ++i) {
    wire::Sample s;
    s.t_us = i * 10'000;
    s.x_mm = 2.0 * i;
    s.left = i <= 50 ? 0.5 : -0.5;
    s.right = 0.5;
    recorder.add(wire::Event{s});
  }
  recorder.add(wire::Event{wire::SerialText{5 * kMs, "one\r\ntw"}});
  recorder.add(wire::Event{wire::SerialText{6 * kMs, "o\n"}});
  result::RunResult result;
  result.verdict = "lost";
  result.time_s = 1.0;
  const History h = recorder.finish(result);
  ASSERT_EQ(h.stretches.size(), 2u);
  EXPECT_EQ(h.stretches[0].manoeuvre, Manoeuvre::ahead);
  EXPECT_EQ(h.stretches[0].to_ns, 500 * kMs);
  EXPECT_EQ(h.stretches[1].manoeuvre, Manoeuvre::turns_left);
  ASSERT_EQ(h.places.size(), 2u);
  EXPECT_EQ(h.places[1].text, "junction 1");
  ASSERT_EQ(h.lines.size(), 2u);
  EXPECT_EQ(h.lines[1].text, "two");
  EXPECT_EQ(h.end_ns, kS);
}

}  // namespace compare_test
}  // namespace robosim::analysis
