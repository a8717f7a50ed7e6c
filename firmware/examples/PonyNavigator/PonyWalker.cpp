#include "PonyWalker.h"

namespace {

using nav::Landmark;
using nav::LandmarkKind;
using nav::Turn;

const int8_t CRUISE = 14;        // duty when driving straight on
const int8_t STEER = 7;          // duty added on one side, subtracted on the other
const int8_t TURN = 12;          // duty of turns on the spot
const int8_t COUNTER = 30;       // reverse duty to brake
const uint8_t STOP_STEPS = 9;    // duration of braking before a rest
const uint8_t SETTLE_STEPS = 5;  // duration of braking at the end of a turn
const uint8_t REST_MS = 60;
const uint16_t WHITE_STEPS = 75;  // steps on white after which the line may have ended
// Distance to roll until the axle is over the arm, in tenths of a line's width (20 mm). The sensors are 60 mm
// ahead of the axle. From these 60 mm, three distances are subtracted: half a width, the stopping distance,
// and a third of a width, which the robot has already driven.
const uint16_t ROLL_TENTHS = 20;
const uint16_t ROUND_TENTHS = 35;  // in tenths of a quarter turn; a line after it is the first line again
const uint8_t SIDE_STEPS = 4;      // debounce time of a dark side sensor
const uint8_t LEFT = 1, RIGHT = 2;

}  // namespace

Landmark PonyWalker::landmark(LandmarkKind kind) {
  Landmark met;
  met.kind = kind;
  met.arms = arms_;
  met.heading = heading_;
  met.at.x = met.at.y = 0;
  met.cost = (millis() - left_at_) / 20;
  pony_.light(kind == LandmarkKind::junction ? Pony::kJunctionLight
              : kind == LandmarkKind::end    ? Pony::kEndLight
                                             : 0);
  return met;
}

Landmark PonyWalker::begin() {
  heading_ = 0;
  arms_ = 0;
  lost_ = false;
  left_at_ = millis();
  if (!pony_.middle() && !turnToLine(1, 6 * quarter_)) return landmark(LandmarkKind::lost);
  // Turns a full circle and records the quarters that have a line.
  const uint16_t start = pony_.now();
  arms_ = 1;
  bool was_dark = true;
  uint16_t elapsed = 0;
  while (elapsed < 6 * quarter_) {
    spin(1, TURN);
    elapsed = pony_.now() - start;
    const bool dark = pony_.middle();
    if (dark && !was_dark && elapsed > quarter_ / 2) {
      if (elapsed > quarter_ * ROUND_TENTHS / 10UL) break;
      arms_ = static_cast<uint8_t>(arms_ | 1 << (elapsed + quarter_ / 2) / quarter_);
    }
    was_dark = dark;
  }
  for (uint8_t i = 0; i < SETTLE_STEPS; ++i) spin(-1, COUNTER);
  pony_.rest(REST_MS);
  if (elapsed >= 6 * quarter_) return landmark(LandmarkKind::lost);
  quarter_ = elapsed / 4;
  const uint8_t count = nav::slotCount(arms_);
  return landmark(count == 1 ? LandmarkKind::end : count == 2 ? LandmarkKind::line : LandmarkKind::junction);
}

Landmark PonyWalker::follow() {
  pony_.light(Pony::kLineLight);
  pony_.forgive();
  while (!lost_ && !pony_.blocked()) {
    if (!followEdge()) {
      stop();
      if (pony_.blocked() || lookAhead()) continue;
      arms_ = 0;
      addArm(Turn::back);
      return landmark(LandmarkKind::end);
    }
    const uint8_t sides = cross();
    if (sides == 0) continue;
    roll();
    stop();
    if (pony_.blocked()) break;
    const bool straight = lookAhead();
    if (!straight && sides != (LEFT | RIGHT)) {  // a bend
      lost_ = !turn(sides == LEFT ? -1 : 1, 1, 1);
      turned(sides == LEFT ? Turn::left : Turn::right);
      continue;
    }
    arms_ = 0;
    addArm(Turn::back);
    if (straight) addArm(Turn::straight);
    if (sides & LEFT) addArm(Turn::left);
    if (sides & RIGHT) addArm(Turn::right);
    return landmark(LandmarkKind::junction);
  }
  stop();
  if (lost_) return landmark(LandmarkKind::lost);
  backOff();  // makes room to turn
  pony_.forgive();
  arms_ = 0;
  return landmark(LandmarkKind::blocked);
}

bool PonyWalker::followEdge() {
  uint16_t white = 0;
  uint8_t side = 0;
  while (white < WHITE_STEPS && side < SIDE_STEPS && !pony_.blocked()) {
    const bool dark = pony_.middle();
    const int8_t steer = dark ? -STEER : STEER;
    pony_.step(CRUISE + steer, CRUISE - steer);
    white = dark ? 0 : white + 1;
    side = pony_.left() || pony_.right() ? side + 1 : 0;
  }
  return side >= SIDE_STEPS;
}

uint8_t PonyWalker::cross() {
  uint16_t left = SIDE_STEPS, right = SIDE_STEPS;  // steps with a dark sensor
  uint16_t white = 0;
  while (white < width_ / 3) {
    pony_.step(CRUISE, CRUISE);
    if (pony_.left()) ++left;
    if (pony_.right()) ++right;
    white = pony_.left() || pony_.right() ? 0 : white + 1;
    if (left <= 3 * width_ && right <= 3 * width_) continue;
    // This is not an arm: the robot has drifted off the line.
    stop();
    turnToLine(left > right ? -1 : 1, quarter_);
    return 0;
  }
  const uint16_t enough = width_ / 2;
  const uint16_t dark = left > right ? left : right;
  if (dark >= enough && dark <= 2 * width_) width_ = (3 * width_ + dark) / 4;
  return static_cast<uint8_t>((left >= enough ? LEFT : 0) | (right >= enough ? RIGHT : 0));
}

void PonyWalker::roll() {
  const uint16_t steps = static_cast<uint16_t>(static_cast<uint32_t>(width_) * ROLL_TENTHS / 10);
  for (uint16_t i = 0; i < steps; ++i) pony_.step(CRUISE, CRUISE);
}

void PonyWalker::stop() {
  for (uint8_t i = 0; i < STOP_STEPS; ++i) pony_.step(-COUNTER, -COUNTER);
  pony_.rest(REST_MS);
}

void PonyWalker::backOff() {
  for (uint16_t i = 0; i < 2 * width_; ++i) pony_.step(-CRUISE, -CRUISE);
  pony_.rest(REST_MS);
}

bool PonyWalker::turnToLine(int8_t dir, uint16_t steps) {
  for (uint16_t i = 0; i < steps; ++i) {
    if (pony_.middle()) break;
    spin(dir, TURN);
  }
  const bool found = pony_.middle();
  for (uint8_t i = 0; i < SETTLE_STEPS; ++i) spin(static_cast<int8_t>(-dir), COUNTER);
  pony_.rest(REST_MS);
  return found;
}

bool PonyWalker::lookAhead() {
  if (pony_.middle()) return true;
  if (turnToLine(1, quarter_ / 3)) return true;
  if (turnToLine(-1, quarter_ * 2 / 3)) return true;
  turnToLine(1, quarter_ / 3);
  return false;
}

bool PonyWalker::turn(int8_t dir, uint8_t quarters, uint8_t count) {
  const uint16_t start = pony_.now();
  const uint16_t most = quarter_ * (quarters + 1);
  uint16_t since = quarter_ / 2;
  bool was_dark = true;
  while (static_cast<uint16_t>(pony_.now() - start) < most) {
    spin(dir, TURN);
    const bool dark = pony_.middle();
    if (since > 0) {
      --since;
    } else if (dark && !was_dark) {
      since = quarter_ / 2;
      if (--count == 0) break;
    }
    was_dark = dark;
  }
  for (uint8_t i = 0; i < SETTLE_STEPS; ++i) spin(static_cast<int8_t>(-dir), COUNTER);
  pony_.rest(REST_MS);
  return count == 0;
}

void PonyWalker::leave(Turn turn_to) {
  left_at_ = millis();
  if (turn_to == Turn::straight) return;
  const int8_t dir = turn_to == Turn::left ? -1 : 1;
  const uint8_t quarters = turn_to == Turn::back ? 2 : 1;
  uint8_t count = 1;
  if (turn_to == Turn::back && nav::hasArm(arms_, nav::turned(heading_, Turn::right))) count = 2;
  lost_ = !turn(dir, quarters, count);
  turned(turn_to);
}
