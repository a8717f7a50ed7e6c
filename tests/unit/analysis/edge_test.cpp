// Differences that never happened: which of a target from itself make one between two targets chance.

#include "sim/analysis/edge.h"

#include <gtest/gtest.h>

#include "sim/analysis/alignment.h"

namespace robosim::analysis {
namespace {

using Kind = Difference::Kind;

Difference of(Kind kind, const char* what, std::int64_t t_ns, const char* one, const char* other) {
  return {kind, what, {t_ns, t_ns}, {one, other}, "", {}};
}

Difference turns_at(std::int64_t t_ns) {
  return of(Kind::motors, "the motors", t_ns, "turns right on the spot for 0.710 s", "drives ahead");
}

Difference late(const char* what, std::int64_t t_ns, const char* one, const char* other) {
  return of(Kind::time, what, t_ns, one, other);
}

TEST(Edge, TheSameKindAboutThenIsThere) {
  EXPECT_EQ(alike(turns_at(10 * kSecond_ns), turns_at(11 * kSecond_ns)), Alike::there);
  EXPECT_EQ(alike(of(Kind::place, "the way after junction 3", 28 * kSecond_ns, "a", "b"),
                  late("junction 4, the way after junction 3", 27 * kSecond_ns, "c", "d")),
            Alike::there)
      << "another place, and the same one much later";
  EXPECT_EQ(alike(of(Kind::place, "the way after junction 3", 10 * kSecond_ns, "a", "b"),
                  turns_at(10 * kSecond_ns)),
            Alike::no);
}

TEST(Edge, TheSameTwoManoeuvresAtAnotherTimeAreElsewhere) {
  EXPECT_EQ(alike(turns_at(30 * kSecond_ns), turns_at(10 * kSecond_ns)), Alike::elsewhere);
  EXPECT_EQ(alike(of(Kind::motors, "the motors", 30 * kSecond_ns, "drives ahead",
                     "turns right on the spot for 2 s"),
                  turns_at(10 * kSecond_ns)),
            Alike::elsewhere)
      << "whichever of the two it does with its own clock";
  EXPECT_EQ(alike(of(Kind::motors, "the motors", 30 * kSecond_ns, "turns left on the spot for 0.710 s",
                     "drives ahead"),
                  turns_at(10 * kSecond_ns)),
            Alike::no);
  EXPECT_EQ(alike(of(Kind::speed, "the motors until 9.0 s", 30 * kSecond_ns, "drives at 20 % on average",
                     "drives at 60 % on average"),
                  of(Kind::speed, "the motors until 3.0 s", 10 * kSecond_ns, "drives at 20 % on average",
                     "drives at 60 % on average")),
            Alike::no);
}

TEST(Edge, AWayThatTakesOneOfTheSameTwoTimesAtAPlaceOfTheSameSortIsElsewhere) {
  const Difference found = late("junction 5, the way after station 3", 25 * kSecond_ns,
                                "comes 2.220 s after the one before", "comes 4.560 s after the one before");
  EXPECT_EQ(alike(late("junction 1, the way after station 1", 42 * kSecond_ns,
                       "comes 4.640 s after the one before", "comes 2.160 s after the one before"),
                  found),
            Alike::elsewhere);
  EXPECT_EQ(alike(late("junction 1, the way after station 1", 42 * kSecond_ns,
                       "comes 9.640 s after the one before", "comes 2.160 s after the one before"),
                  found),
            Alike::no)
      << "another time";
  EXPECT_EQ(alike(late("junction 1, the way after junction 2", 42 * kSecond_ns,
                       "comes 4.640 s after the one before", "comes 2.160 s after the one before"),
                  found),
            Alike::no)
      << "between two junctions";
}

TEST(Edge, WhatHasACauseWithANameOrIsPrintedIsNoChance) {
  Difference own = turns_at(10 * kSecond_ns);
  own.cause = "integer width: -25536 = 40000 - 2^16";
  EXPECT_EQ(alike(own, turns_at(10 * kSecond_ns)), Alike::no);
  const Difference line = of(Kind::line, "line 3 of the serial port", kSecond_ns, "says \"a\"", "says \"b\"");
  EXPECT_EQ(alike(line, line), Alike::no);
}

TEST(Edge, AnEndIsThereWheneverItComesIfItIsOneOfTheSameTwo) {
  const Difference found =
      of(Kind::verdict, "how it ends", 60 * kSecond_ns, "reached: the goal", "lost: the line");
  EXPECT_EQ(alike(of(Kind::verdict, "how it ends", 20 * kSecond_ns, "reached: so", "lost: so"), found),
            Alike::there);
  EXPECT_EQ(alike(of(Kind::verdict, "how it ends", 60 * kSecond_ns, "reached: so", "stuck: so"), found),
            Alike::no);
}

}  // namespace
}  // namespace robosim::analysis
