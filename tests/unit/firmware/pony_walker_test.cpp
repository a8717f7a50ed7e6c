#include "PonyWalker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "walked_floor.h"

namespace pony_walker_test {

using nav::Turn;
using testing::ElementsAre;

constexpr std::uint8_t kPonyBumper = 7;
constexpr std::uint8_t kSensors[] = {A0, A1, A2};

/// A simulated Pony, the robot of the sketch PonyNavigator. Its motors follow the bits of shift register 0
/// with a time constant of 50 ms, up to 257 mm/s. Its sensors read HIGH on the line.
class PonyBody : public walked::Body {
 public:
  explicit PonyBody(std::vector<walked::Line> lines) : Body(std::move(lines), kPonyBumper) { look(); }
  double left_wheel = 1;  ///< actual speed as a share of the commanded speed

  void look() {
    for (int i = 0; i < 3; ++i)
      fake::board.pins[kSensors[i]].reads = darkness(60, (i - 1) * 36) > 500 ? HIGH : LOW;
  }

 private:
  void drive() override {
    const int code = fake::board.shifted.empty() ? 0 : fake::board.shifted.back();
    follow(left_, left_wheel * (!!(code & 0x40) - !!(code & 0x20)));
    follow(right_, !!(code & 0x10) - !!(code & 0x08));
    go(left_, right_);
    look();
  }
  static void follow(double& speed, double told) { speed += (257 * told - speed) * kPieceS / 0.05; }

  double left_ = 0, right_ = 0;
};

/// A Pony on a floor. Records each landmark with the time, the Pony's lights and the axle's position.
struct Ride {
  explicit Ride(std::vector<walked::Line> lines) : body(std::move(lines)) { pony.begin(); }

  void tell(const nav::Landmark& met) {
    static const char* const kinds[] = {"line", "junction", "end", "blocked", "loop", "lost"};
    std::string arms;
    for (int i = 0; i < 4; ++i) arms += met.arms >> i & 1 ? '1' : '0';
    char text[160];
    std::snprintf(text, sizeof text,
                  "%s %s, heading %d at %d,%d, cost %d, light %d; axle at %.0f,%.0f, %.2f rad, %u ms\n",
                  kinds[static_cast<int>(met.kind)], arms.c_str(), met.heading, static_cast<int>(met.at.x),
                  static_cast<int>(met.at.y), static_cast<int>(met.cost), fake::board.shifted.back() & 7,
                  std::lround(body.x) + 0.0, std::lround(body.y) + 0.0, body.angle,
                  static_cast<unsigned>(fake::board.now_us / 1000));
    said += text;
  }
  void go(const std::vector<Turn>& turns) {
    tell(walker.begin());
    tell(walker.follow());
    for (const Turn turn : turns) {
      walker.leave(turn);
      tell(walker.follow());
    }
  }

  PonyBody body;
  Pony pony;
  PonyWalker walker{pony};
  std::string said = "\n";
};

constexpr Turn kAhead = Turn::straight, kToRight = Turn::right, kRound = Turn::back, kToLeft = Turn::left;

TEST(PonyWalkerTest, ComesToBothEndsOfALine) {
  Ride ride({{-300, 0, 300, 0}});
  ride.go({kRound, kRound});
  EXPECT_EQ(ride.said, R"(
line 1010, heading 0 at 0,0, cost 156, light 0; axle at 0,0, 6.16 rad, 3134 ms
end 0010, heading 0 at 0,0, cost 325, light 2; axle at 262,-9, 6.40 rad, 6500 ms
end 1000, heading 2 at 0,0, cost 344, light 2; axle at -257,9, 9.51 rad, 13398 ms
end 0010, heading 0 at 0,0, cost 340, light 2; axle at 264,-9, 12.64 rad, 20198 ms
)");
}

TEST(PonyWalkerTest, KnowsHowLongALineOfMoreThanAMinuteIs) {
  Ride ride({{-300, 0, 9000, 0}});
  ride.walker.begin();
  const std::uint32_t left_us = fake::board.now_us;
  const nav::Landmark end = ride.walker.follow();
  EXPECT_EQ(end.kind, nav::LandmarkKind::end);
  EXPECT_GT(fake::board.now_us - left_us, 66'000'000u) << "a time in ms does not fit in 16 bits";
  EXPECT_NEAR(end.cost, fake::board.now_us / 20'000, 2) << "the cost includes the duration of begin()";
}

TEST(PonyWalkerTest, CountsItsHeadingAnewWhereItBeginsAnew) {
  Ride ride({{-300, 0, 300, 0}, {300, -300, 300, 300}});
  ride.go({kToRight});
  EXPECT_EQ(ride.walker.begin().heading, 0) << "the heading was 1 before";
}

TEST(PonyWalkerTest, TellsTheWaysOfATee) {
  Ride ride({{-300, 0, 300, 0}, {300, -300, 300, 300}});
  ride.go({kToRight, kRound, kAhead, kRound, kToRight, kRound});
  EXPECT_EQ(ride.said, R"(
line 1010, heading 0 at 0,0, cost 156, light 0; axle at 0,0, 6.16 rad, 3134 ms
junction 0111, heading 0 at 0,0, cost 340, light 1; axle at 299,-11, 6.19 rad, 6818 ms
end 0001, heading 1 at 0,0, cost 212, light 2; axle at 309,261, 7.94 rad, 11076 ms
junction 0111, heading 3 at 0,0, cost 184, light 1; axle at 292,3, 11.01 rad, 14772 ms
end 0100, heading 3 at 0,0, cost 168, light 2; axle at 291,-260, 11.12 rad, 18144 ms
junction 0111, heading 1 at 0,0, cost 184, light 1; axle at 308,-2, 14.17 rad, 21834 ms
end 1000, heading 2 at 0,0, cost 323, light 2; axle at -256,9, 15.80 rad, 28310 ms
junction 0111, heading 0 at 0,0, cost 359, light 1; axle at 297,-10, 18.75 rad, 35504 ms
)");
}

TEST(PonyWalkerTest, TellsTheWaysOfACross) {
  Ride ride({{-300, 0, 600, 0}, {300, -300, 300, 300}});
  ride.go({kAhead, kRound, kToRight, kRound, kToLeft});
  EXPECT_EQ(ride.said, R"(
line 1010, heading 0 at 0,0, cost 156, light 0; axle at 0,0, 6.16 rad, 3134 ms
junction 1111, heading 0 at 0,0, cost 286, light 1; axle at 299,-11, 6.31 rad, 5728 ms
end 0010, heading 0 at 0,0, cost 168, light 2; axle at 565,-9, 6.38 rad, 9106 ms
junction 1111, heading 2 at 0,0, cost 187, light 1; axle at 301,8, 9.45 rad, 12846 ms
end 0100, heading 3 at 0,0, cost 210, light 2; axle at 292,-265, 11.13 rad, 17064 ms
junction 1111, heading 1 at 0,0, cost 180, light 1; axle at 309,-1, 14.15 rad, 20674 ms
end 0010, heading 0 at 0,0, cost 209, light 2; axle at 560,-9, 12.64 rad, 24858 ms
)");
}

TEST(PonyWalkerTest, TellsAWayToTheLeft) {
  Ride ride({{-300, 0, 600, 0}, {300, -300, 300, 0}});
  ride.go({kToLeft, kRound, kToRight});
  EXPECT_EQ(ride.said, R"(
line 1010, heading 0 at 0,0, cost 156, light 0; axle at 0,0, 6.16 rad, 3134 ms
junction 1011, heading 0 at 0,0, cost 286, light 1; axle at 299,-11, 6.31 rad, 5728 ms
end 0100, heading 3 at 0,0, cost 202, light 2; axle at 291,-261, 4.81 rad, 9786 ms
junction 1011, heading 1 at 0,0, cost 246, light 1; axle at 308,0, 7.80 rad, 14708 ms
end 1000, heading 2 at 0,0, cost 329, light 2; axle at -265,9, 9.56 rad, 21300 ms
)");
}

TEST(PonyWalkerTest, TellsAWayToTheRight) {
  Ride ride({{-300, 0, 600, 0}, {300, 300, 300, 0}});
  ride.go({kToRight, kRound, kToLeft});
  EXPECT_EQ(ride.said, R"(
line 1010, heading 0 at 0,0, cost 156, light 0; axle at 0,0, 6.16 rad, 3134 ms
junction 1110, heading 0 at 0,0, cost 285, light 1; axle at 297,-11, 6.31 rad, 5716 ms
end 0001, heading 1 at 0,0, cost 211, light 2; axle at 309,265, 7.93 rad, 9942 ms
junction 1110, heading 3 at 0,0, cost 242, light 1; axle at 290,1, 10.95 rad, 14792 ms
end 1000, heading 2 at 0,0, cost 325, light 2; axle at -265,8, 9.59 rad, 21302 ms
)");
}

TEST(PonyWalkerTest, TurnsRoundOnAJunctionWithAWayToItsRight) {
  Ride ride({{-300, 0, 600, 0}, {300, 300, 300, 0}});
  ride.go({kRound, kRound});
  EXPECT_EQ(ride.said, R"(
line 1010, heading 0 at 0,0, cost 156, light 0; axle at 0,0, 6.16 rad, 3134 ms
junction 1110, heading 0 at 0,0, cost 285, light 1; axle at 297,-11, 6.31 rad, 5716 ms
end 1000, heading 2 at 0,0, cost 360, light 2; axle at -257,9, 9.51 rad, 12918 ms
junction 1110, heading 0 at 0,0, cost 295, light 1; axle at 298,-9, 12.58 rad, 18820 ms
)");
}

TEST(PonyWalkerTest, TakesBendsToTheRight) {
  Ride ride({{-300, 0, 300, 0}, {300, 0, 300, 300}});
  ride.go({kRound});
  EXPECT_EQ(ride.said, R"(
line 1010, heading 0 at 0,0, cost 156, light 0; axle at 0,0, 6.16 rad, 3134 ms
end 0001, heading 1 at 0,0, cost 552, light 2; axle at 309,265, 7.93 rad, 11052 ms
end 1000, heading 2 at 0,0, cost 558, light 2; axle at -257,9, 9.51 rad, 22218 ms
)");
}

TEST(PonyWalkerTest, TakesBendsToTheLeft) {
  Ride ride({{-300, 0, 300, 0}, {300, 0, 300, -300}});
  ride.go({kRound});
  EXPECT_EQ(ride.said, R"(
line 1010, heading 0 at 0,0, cost 156, light 0; axle at 0,0, 6.16 rad, 3134 ms
end 0100, heading 3 at 0,0, cost 541, light 2; axle at 291,-261, 4.83 rad, 10828 ms
end 1000, heading 2 at 0,0, cost 568, light 2; axle at -259,9, 9.52 rad, 22190 ms
)");
}

TEST(PonyWalkerTest, DrivesOverAGap) {
  Ride ride({{-300, 0, 200, 0}, {230, 0, 400, 0}});
  ride.go({kRound});
  EXPECT_EQ(ride.said, R"(
line 1010, heading 0 at 0,0, cost 156, light 0; axle at 0,0, 6.16 rad, 3134 ms
end 0010, heading 0 at 0,0, cost 363, light 2; axle at 362,-9, 6.36 rad, 7276 ms
end 1000, heading 2 at 0,0, cost 390, light 2; axle at -262,9, 9.51 rad, 15078 ms
)");
}

TEST(PonyWalkerTest, FindsALineThatGoesOnASide) {
  Ride ride({{-300, 0, 200, 0}, {200, 22, 500, 22}});
  ride.go({});
  EXPECT_EQ(ride.said, R"(
line 1010, heading 0 at 0,0, cost 156, light 0; axle at 0,0, 6.16 rad, 3134 ms
end 0010, heading 0 at 0,0, cost 425, light 2; axle at 456,12, 6.38 rad, 8510 ms
)");
}

TEST(PonyWalkerTest, FindsALineThatSlipsAway) {
  Ride ride({{-300, 0, 200, 0}, {200, 0, 400, 60}, {400, 60, 600, 60}});
  ride.go({kRound});
  EXPECT_EQ(ride.said, R"(
line 1010, heading 0 at 0,0, cost 156, light 0; axle at 0,0, 6.16 rad, 3134 ms
end 0010, heading 0 at 0,0, cost 441, light 2; axle at 556,50, 6.35 rad, 8836 ms
end 1000, heading 2 at 0,0, cost 456, light 2; axle at -256,9, 9.51 rad, 17958 ms
)");
}

TEST(PonyWalkerTest, TurnsRoundAtAnEndFromWhichItFaces) {
  Ride ride({{-300, 0, 300, 0}});
  ride.body.x = 300;
  ride.go({});
  EXPECT_EQ(ride.said, R"(
end 1000, heading 0 at 0,0, cost 230, light 2; axle at 300,0, 9.32 rad, 4612 ms
end 0010, heading 0 at 0,0, cost 517, light 2; axle at -265,9, 9.54 rad, 10340 ms
)");
}

TEST(PonyWalkerTest, BeginsOnAJunction) {
  Ride ride({{0, 0, 300, 0}, {0, 0, 0, 300}, {-300, 0, 0, 0}});
  ride.go({kRound});
  EXPECT_EQ(ride.said, R"(
junction 1110, heading 0 at 0,0, cost 156, light 1; axle at 0,0, 6.16 rad, 3134 ms
end 0010, heading 0 at 0,0, cost 325, light 2; axle at 262,-9, 6.40 rad, 6500 ms
junction 1110, heading 2 at 0,0, cost 190, light 1; axle at 2,10, 9.43 rad, 10318 ms
)");
}

TEST(PonyWalkerTest, IsLostWhereItTurnsToNoLine) {
  Ride ride({{-300, 0, 300, 0}, {0, -300, 0, 300}});
  ride.go({kToLeft});
  EXPECT_EQ(ride.said, R"(
junction 1111, heading 0 at 0,0, cost 156, light 1; axle at 0,0, 6.16 rad, 3134 ms
end 0010, heading 0 at 0,0, cost 325, light 2; axle at 262,-9, 6.40 rad, 6500 ms
lost 0010, heading 3 at 0,0, cost 82, light 0; axle at 265,-8, 3.32 rad, 8140 ms
)");
}

TEST(PonyWalkerTest, WaitsForAnObstacleAndGoesOn) {
  Ride ride({{-300, 0, 600, 0}});
  ride.body.wall_x = 300;
  ride.body.wall_ms = 1500;
  ride.go({});
  EXPECT_EQ(ride.said, R"(
line 1010, heading 0 at 0,0, cost 156, light 0; axle at 0,0, 6.16 rad, 3134 ms
end 0010, heading 0 at 0,0, cost 516, light 2; axle at 562,-9, 6.37 rad, 10335 ms
)");
}

TEST(PonyWalkerTest, BacksUpBeforeAnObstacleThatStays) {
  Ride ride({{-300, 0, 600, 0}});
  ride.body.wall_x = 300;
  ride.go({kRound});
  EXPECT_EQ(ride.said, R"(
line 1010, heading 0 at 0,0, cost 156, light 0; axle at 0,0, 6.16 rad, 3134 ms
blocked 0000, heading 0 at 0,0, cost 523, light 0; axle at 179,-9, 6.26 rad, 10478 ms
end 1000, heading 2 at 0,0, cost 311, light 2; axle at -263,9, 9.48 rad, 16702 ms
)");
}

TEST(PonyWalkerTest, StandsBeforeAnObstacleAtAJunction) {
  Ride ride({{-300, 0, 600, 0}, {200, 0, 200, 300}});
  ride.body.wall_x = 260;
  ride.go({kRound});
  EXPECT_EQ(ride.said, R"(
line 1010, heading 0 at 0,0, cost 156, light 0; axle at 0,0, 6.16 rad, 3134 ms
blocked 0000, heading 0 at 0,0, cost 515, light 0; axle at 154,-9, 6.26 rad, 10310 ms
end 1000, heading 2 at 0,0, cost 307, light 2; axle at -263,9, 9.49 rad, 16458 ms
)");
}

TEST(PonyWalkerTest, StandsBeforeAnObstacleAtAnEnd) {
  Ride ride({{-300, 0, 300, 0}});
  ride.body.wall_x = 335;
  ride.go({kRound});
  EXPECT_EQ(ride.said, R"(
line 1010, heading 0 at 0,0, cost 156, light 0; axle at 0,0, 6.16 rad, 3134 ms
blocked 0000, heading 0 at 0,0, cost 537, light 0; axle at 214,-15, 6.40 rad, 10752 ms
end 1000, heading 2 at 0,0, cost 324, light 2; axle at -260,9, 9.52 rad, 17248 ms
)");
}

TEST(PonyWalkerTest, SteersAgainstUnequalMotors) {
  Ride ride({{-300, 0, 600, 0}, {300, 0, 300, 300}});
  ride.body.left_wheel = 0.94;
  ride.go({kToRight, kRound});
  EXPECT_EQ(ride.said, R"(
line 1010, heading 0 at 0,0, cost 161, light 0; axle at 0,0, 6.16 rad, 3224 ms
junction 1110, heading 0 at 0,0, cost 295, light 1; axle at 296,-12, 6.35 rad, 5908 ms
end 0001, heading 1 at 0,0, cost 213, light 2; axle at 309,260, 7.93 rad, 10176 ms
junction 1110, heading 3 at 0,0, cost 251, light 1; axle at 288,2, 10.91 rad, 15206 ms
)");
}

TEST(PonyWalkerTest, BeginsAskewBesideTheLine) {
  Ride ride({{-300, 0, 600, 0}});
  ride.body.y = 8;
  ride.body.angle = 0.2;
  ride.go({});
  EXPECT_EQ(ride.said, R"(
line 1010, heading 0 at 0,0, cost 229, light 0; axle at 0,8, 9.45 rad, 4580 ms
end 0010, heading 0 at 0,0, cost 397, light 2; axle at -262,9, 9.52 rad, 7944 ms
)");
}

class PonyTest : public testing::Test {
 protected:
  PonyTest() {
    fake::board = fake::Board{};
    fake::board.pins[kPonyBumper].reads = HIGH;
    pony.begin();
  }
  ~PonyTest() override { fake::board = fake::Board{}; }

  static int bits(int reg) { return fake::board.shifted[fake::board.shifted.size() - 1 - reg]; }
  /// Calls Pony::step() `count` times. Returns the number of calls after which all bits of `mask` are set in
  /// shift register 0.
  int steps(int mask, int left, int right, int count = 15) {
    int set = 0;
    for (int i = 0; i < count; ++i) {
      pony.step(static_cast<std::int8_t>(left), static_cast<std::int8_t>(right));
      set += (bits(0) & mask) == mask;
    }
    return set;
  }

  Pony pony;
};

TEST_F(PonyTest, BeginsDarkAndAtRest) {
  EXPECT_EQ(fake::board.pins[kPonyBumper].mode, INPUT_PULLUP);
  EXPECT_THAT(fake::board.shifted, ElementsAre(0x7F, 0x7F, 0));
  EXPECT_FALSE(pony.blocked() || pony.left() || pony.middle() || pony.right());
  EXPECT_EQ(pony.now(), 0);
}

TEST_F(PonyTest, PulsesItsMotorsForADutyOfThirty) {
  EXPECT_EQ(steps(0x40, 14, 0), 7);
  EXPECT_EQ(steps(0x20, -14, 0), 7);
  EXPECT_EQ(steps(0x10, 0, 21), 11) << "21 of 30 ms, in steps of 2 ms";
  EXPECT_EQ(steps(0x08, 0, -7), 4);
  EXPECT_EQ(steps(0x50, 30, 30), 15);
  EXPECT_EQ(steps(0x28, -30, -30), 15);
  EXPECT_EQ(steps(0x78, 30, 30), 0) << "never both ways at once";
  EXPECT_EQ(steps(0x40, 0, 30) + steps(0x20, 0, 30) + steps(0x10, 0, 0) + steps(0x08, 0, 0), 0);
  EXPECT_EQ(pony.now(), 11 * 15);
}

TEST_F(PonyTest, StepsEveryTwoMilliseconds) {
  const auto start = fake::board.now_us;
  steps(0, 10, 10, 100);
  EXPECT_NEAR(static_cast<double>(fake::board.now_us - start), 200'000, 30);
  fake::board.now_us += 50'000;  // a late caller does not shorten the following steps
  const auto late = fake::board.now_us;
  steps(0, 10, 10, 100);
  EXPECT_NEAR(static_cast<double>(fake::board.now_us - late), 198'000, 100);
  const auto resting = pony.now();
  pony.rest(60);
  EXPECT_EQ(pony.now() - resting, 30);
}

TEST_F(PonyTest, BelievesASensorAfterTwoLooks) {
  for (const int i : {0, 1, 2}) {
    const auto seen = [&] { return i == 0 ? pony.left() : i == 1 ? pony.middle() : pony.right(); };
    fake::board.pins[kSensors[i]].reads = HIGH;
    pony.step(0, 0);
    EXPECT_FALSE(seen());
    pony.step(0, 0);
    EXPECT_TRUE(seen());
    EXPECT_EQ(pony.left() + pony.middle() + pony.right(), 1);
    fake::board.pins[kSensors[i]].reads = LOW;
    pony.step(0, 0);
    EXPECT_TRUE(seen());
    fake::board.pins[kSensors[i]].reads = HIGH;
    pony.step(0, 0);
    EXPECT_TRUE(seen());
    fake::board.pins[kSensors[i]].reads = LOW;
    pony.step(0, 0);
    pony.step(0, 0);
    EXPECT_FALSE(seen());
  }
}

TEST_F(PonyTest, ShowsEachNumberByItsSegments) {
  // The lit segments of the digits 0 to 9. The bits 0 to 6 are the segments e, g, f, a, b, c, d.
  const int digits[] = {0x7D, 0x30, 0x5B, 0x7A, 0x36, 0x6E, 0x6F, 0x38, 0x7F, 0x3E};
  for (int n = 0; n < 100; ++n) {
    pony.show(static_cast<std::uint8_t>(n));
    EXPECT_EQ(0x7F ^ bits(1), digits[n % 10]) << n;
    EXPECT_EQ(0x7F ^ bits(2), n < 10 ? 0 : digits[n / 10]) << n;
  }
  for (const int n : {100, 255}) {
    pony.show(static_cast<std::uint8_t>(n));
    EXPECT_EQ(0x7F ^ bits(1), 2) << "a dash";
    EXPECT_EQ(0x7F ^ bits(2), 2);
  }
}

TEST_F(PonyTest, LightsStayWhileItDrivesAndBeeps) {
  pony.light(Pony::kJunctionLight | Pony::kLineLight);
  EXPECT_EQ(bits(0), 0x05);
  EXPECT_EQ(steps(0x05, 30, 0), 15);
  pony.beep(20);
  EXPECT_EQ(steps(0x85, 0, 0, 30), 10) << "the beep lasts for 20 ms";
  pony.light(Pony::kEndLight);
  EXPECT_EQ(bits(0), 0x02);
  pony.light(0xF8);
  EXPECT_EQ(bits(0), 0x00);
}

TEST_F(PonyTest, WaitsWhileItsBumperIsPressedAndAfterFiveSecondsItIsBlocked) {
  pony.beep(1000);
  steps(0, 30, 30, 2);
  const auto start = fake::board.now_us;
  fake::board.on_wait = [&] {
    const bool goes = fake::board.now_us - start > 2'000'000;
    fake::board.pins[kPonyBumper].reads = goes ? HIGH : LOW;
    EXPECT_TRUE(goes || bits(0) == 0) << "the Pony is at rest and silent";
  };
  fake::board.pins[kPonyBumper].reads = LOW;
  pony.step(30, 30);
  EXPECT_NEAR(fake::board.now_us - start, 2'002'000, 2'100);
  EXPECT_FALSE(pony.blocked());
  fake::board.on_wait = nullptr;
  fake::board.pins[kPonyBumper].reads = LOW;
  const auto again = fake::board.now_us;
  pony.step(30, 30);
  EXPECT_NEAR(fake::board.now_us - again, 5'022'000, 4'000);
  EXPECT_TRUE(pony.blocked());
  const auto blocked = fake::board.now_us;
  pony.step(-30, -30);
  EXPECT_NEAR(fake::board.now_us - blocked, 2'000, 100) << "no wait while the pony is blocked";
  pony.forgive();
  EXPECT_FALSE(pony.blocked());
}

}  // namespace pony_walker_test
