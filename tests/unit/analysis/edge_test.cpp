// Tests how `robosim compare` decides whether a difference between two targets is due to chance. It is due to
// chance if one target, with a slightly wrong clock, behaves like the other. The runs are fictitious.

#include "sim/campaign/analysis/edge.h"

#include <gtest/gtest.h>

#include "sim/campaign/analysis/alignment.h"

namespace robosim::analysis {
namespace edge_test {

using Kind = Difference::Kind;

/// Returns a run whose robot drives ahead, does `manoeuvre` for 1 s, and drives ahead again to the end.
History turning_at(std::int64_t at_ns, Manoeuvre manoeuvre, std::int64_t end_ns = 30 * kSecond_ns) {
  History h;
  h.verdict = "timeout";
  h.end_ns = end_ns;
  h.stretches = {{0, at_ns, Manoeuvre::ahead, 0.5, 0.5},
                 {at_ns, at_ns + kSecond_ns, manoeuvre},
                 {at_ns + kSecond_ns, end_ns, Manoeuvre::ahead, 0.5, 0.5}};
  return h;
}

History lost_at(std::int64_t t_ns) {
  History h = turning_at(5 * kSecond_ns, Manoeuvre::turns_left);
  h.places = {{t_ns, kOffTheLine}};
  h.lost_ns = t_ns;
  h.verdict = "lost";
  return h;
}

class RobotOnTheEdge : public testing::Test {
 protected:
  const History here_ = turning_at(10 * kSecond_ns, Manoeuvre::turns_left);
  const History there_ = turning_at(10 * kSecond_ns, Manoeuvre::turns_right);
  const Difference found_ = *compare(here_, there_).first;
};

TEST_F(RobotOnTheEdge, DoesAsTheOtherIfItTurnsThatWayThen) {
  EXPECT_TRUE(does_as(turning_at(10'300'000'000, Manoeuvre::turns_right), there_, found_));
  EXPECT_FALSE(does_as(here_, there_, found_));
}

TEST_F(RobotOnTheEdge, DoesNotAsTheOtherIfItTurnsThatWayAtAnotherTimeOnly) {
  EXPECT_FALSE(does_as(turning_at(20 * kSecond_ns, Manoeuvre::turns_right), there_, found_));
}

TEST_F(RobotOnTheEdge, MayDoWhatItWillTwoSecondsLater) {
  History later = there_;
  later.stretches.back().to_ns = 15 * kSecond_ns;
  later.stretches.push_back({15 * kSecond_ns, 30 * kSecond_ns, Manoeuvre::stands});
  EXPECT_TRUE(does_as(later, there_, found_));
}

TEST_F(RobotOnTheEdge, HasNotShownItIfItsRunEndsBefore) {
  EXPECT_FALSE(does_as(turning_at(3 * kSecond_ns, Manoeuvre::ahead, 6 * kSecond_ns), there_, found_));
}

TEST_F(RobotOnTheEdge, DoesAsTheOtherIfItEndsAsThatDoesAtAboutThatTime) {
  const History goes_on = turning_at(5 * kSecond_ns, Manoeuvre::turns_left);
  const Difference found = *compare(goes_on, lost_at(20 * kSecond_ns)).first;
  EXPECT_EQ(found.kind, Kind::place);
  EXPECT_TRUE(does_as(lost_at(18 * kSecond_ns), lost_at(20 * kSecond_ns), found));
  EXPECT_FALSE(does_as(lost_at(8 * kSecond_ns), lost_at(20 * kSecond_ns), found))
      << "events after a robot is lost are not compared";
}

constexpr std::int64_t kElsewhere_ns = 60 * kSecond_ns;

Difference turns(Kind kind, const char* one, const char* other) {
  return {kind, "the motors", {kElsewhere_ns, kElsewhere_ns}, {one, other}, "", {}};
}

TEST(Edge, TheSameTwoManoeuvresAreTheSameWaysWhicheverComesFirst) {
  Difference found = turns(Kind::motors, "turns right on the spot for 0.710 s", "drives ahead");
  found.t_ns = {};
  EXPECT_TRUE(is_alike(turns(Kind::motors, "drives ahead", "turns right on the spot for 2 s"), found));
  EXPECT_FALSE(is_alike(turns(Kind::motors, "drives ahead", "turns left on the spot for 2 s"), found));
  EXPECT_FALSE(is_alike(turns(Kind::speed, "drives ahead", "turns right on the spot for 2 s"), found));
  found.t_ns = {kElsewhere_ns + kSecond_ns, kElsewhere_ns + kSecond_ns};
  EXPECT_TRUE(is_alike(turns(Kind::motors, "drives ahead", "turns left on the spot for 2 s"), found))
      << "the difference is at about the same time";
}

TEST(Edge, OneOfTheSameTwoTimesAtAPlaceOfTheSameSortIsTheSameWay) {
  const auto late = [](const char* what, const char* one, const char* other) {
    return Difference{Kind::time, what, {kElsewhere_ns, kElsewhere_ns}, {one, other}, "", {}};
  };
  Difference found = late("junction 5, the way after station 3", "comes 2.220 s after the previous one",
                          "comes 4.560 s after the previous one");
  found.t_ns = {};
  EXPECT_TRUE(is_alike(late("junction 1, the way after station 1", "comes 4.640 s after the previous one",
                            "comes 2.160 s after the previous one"),
                       found));
  EXPECT_FALSE(is_alike(late("junction 1, the way after station 1", "comes 9.640 s after the previous one",
                             "comes 2.160 s after the previous one"),
                        found));
  EXPECT_FALSE(is_alike(late("junction 1, the way after junction 2", "comes 4.640 s after the previous one",
                             "comes 2.160 s after the previous one"),
                        found));
}

TEST_F(RobotOnTheEdge, GoesOneOfTwoWaysByWhatItsMotorsDoThere) {
  const auto choice = Choice::of(found_, here_, there_);
  ASSERT_TRUE(choice);
  EXPECT_TRUE(choice->is_as_first(turning_at(10'800'000'000, Manoeuvre::turns_left)));
  EXPECT_FALSE(choice->is_as_first(turning_at(10'800'000'000, Manoeuvre::turns_right)));
  EXPECT_FALSE(choice->is_as_first(turning_at(20 * kSecond_ns, Manoeuvre::turns_left))) << "another time";
}

TEST_F(RobotOnTheEdge, GoesOneOfTwoWaysByWhenItComesToAPlace) {
  const auto lap_at = [](std::initializer_list<std::int64_t> laps_s) {
    History h = turning_at(5 * kSecond_ns, Manoeuvre::turns_left, 90 * kSecond_ns);
    for (const std::int64_t t_s : laps_s) h.places.push_back({t_s * kSecond_ns, "lap 1"});
    return h;
  };
  const History soon = lap_at({20}), late = lap_at({48}), never = lap_at({});
  const auto between = Choice::of(*compare(soon, late).first, soon, late);
  ASSERT_TRUE(between);
  EXPECT_TRUE(between->is_as_first(lap_at({33})));
  EXPECT_FALSE(between->is_as_first(lap_at({35, 36})));
  EXPECT_FALSE(between->is_as_first(never));
  const auto ever = Choice::of(*compare(never, soon).first, never, soon);
  ASSERT_TRUE(ever);
  EXPECT_TRUE(ever->is_as_first(late));
  EXPECT_FALSE(ever->is_as_first(lap_at({24})));
}

TEST_F(RobotOnTheEdge, GoesOneOfTwoWaysByHowItEnds) {
  History crashed = here_;
  crashed.verdict = "crashed";
  const auto choice = Choice::of(*compare(crashed, here_).first, crashed, here_);
  ASSERT_TRUE(choice);
  EXPECT_TRUE(choice->is_as_first(crashed));
  EXPECT_FALSE(choice->is_as_first(there_));
}

TEST(Edge, TargetsAreAlikeThatGoBothWaysAboutAsOften) {
  EXPECT_EQ(alikeness({29, 14}, {29, 21}), Alikeness::alike);
  EXPECT_EQ(alikeness({29, 14}, {29, 22}), Alikeness::alike);
  EXPECT_EQ(alikeness({29, 14}, {29, 23}), Alikeness::apart)
      << "one in 35 pairs of similar targets differs so much";
  EXPECT_EQ(alikeness({29, 29}, {29, 0}), Alikeness::apart) << "a fault of one target";
}

TEST(Edge, ATargetThatNeverGoesTheOthersWayIsApart) {
  EXPECT_EQ(alikeness({29, 27}, {29, 29}), Alikeness::rare) << "more runs may decide";
  EXPECT_EQ(alikeness({153, 148}, {153, 153}), Alikeness::apart) << "a race that occurs in some runs only";
  EXPECT_EQ(alikeness({153, 148}, {153, 152}), Alikeness::alike);
  EXPECT_EQ(alikeness({153, 152}, {153, 153}), Alikeness::alike)
      << "only the run with the exact clock differs";
}

TEST(Edge, WhatHasACauseWithANameOrIsPrintedIsNoChance) {
  EXPECT_TRUE(is_of_driving({Kind::motors, "the motors", {}, {}, "", {}}));
  EXPECT_FALSE(is_of_driving({Kind::motors, "the motors", {}, {}, "integer width: …", {}}));
  EXPECT_FALSE(is_of_driving({Kind::line, "line 3 of the serial port", {}, {}, "", {}}));
}

}  // namespace edge_test
}  // namespace robosim::analysis
