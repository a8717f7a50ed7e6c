#include "LineWalker.h"

namespace {

using nav::Heading;
using nav::Landmark;
using nav::LandmarkKind;
using nav::Turn;

const float QUARTER = 1.5707963f;
const float FADE_BELOW = 0.15f;  // rad
const float FADE_MM = 150;       // time constant of fading, as a distance
const float MOST_BEHIND = 6;     // mm that a wheel tries to catch up
const float SEARCH = 0.6f;       // rad to either side of where a line should be
const float ARM_NEAR = 0.35f;    // rad from a quarter, while looking round
const float CREEP_FROM = 3;      // mm before the end of a roll
const float END_MM = 12;         // so long without a line, and it may have ended
const float SIDE_MM = 150;       // so far it looks for a line lost to a side
const float BACK_UP_MM = 35;
const float LOOP_NEAR = 100, LOOP_LEAST = 500;  // mm
const int16_t TURN_LEAD = 300;                  // 0.001 sensor distances before the middle a turn brakes
const uint16_t LINE_AND_ARM = 2700;  // sum of all sensors; a line alone gives 2100, at 38 degrees 2700
const uint16_t CLEAR_MS = 500;       // the bumper free for so long, and it goes on
const uint8_t STILL_STEPS = 4;

// Where along the way a sensor was dark.
struct Dark {
  float from = 0, to = 0;
  bool any = false;

  void note(bool dark, float at) {
    if (!dark) return;
    if (!any) from = at;
    any = true;
    to = at;
  }
  float length() const { return to - from; }
  float middle() const { return 0.5f * (from + to); }
};

float magnitude(float x) { return x < 0 ? -x : x; }
float least(float a, float b) { return a < b ? a : b; }
float limited(float x, float most) { return x > most ? most : x < -most ? -most : x; }

int16_t dutyOf(float speed, float duty) {
  if ((speed >= 0 && duty < 0) || (speed <= 0 && duty > 0)) return 0;  // never against the way it turns
  return static_cast<int16_t>(limited(duty, 255));
}

}  // namespace

void LineWalker::setup() {
  sensors_.begin();
  encoders_.begin();
  motors_.setSmallestDuty(s_.smallest_duty);
  motors_.begin();
  pinMode(bumper_pin_, INPUT_PULLUP);
}

void LineWalker::step(float left, float right) {
  if (left == 0 && right == 0) behind_left_ = behind_right_ = 0;
  const int16_t left_duty = dutyOf(left, left * s_.duty_per_speed + behind_left_ * s_.duty_per_mm);
  const int16_t right_duty = dutyOf(right, right * s_.duty_per_speed + behind_right_ * s_.duty_per_mm);
  encoders_.setDirections(left_duty, right_duty);
  motors_.drive(left_duty, right_duty);

  const uint32_t step_us = 1000UL * kStepMs;
  due_us_ += step_us;
  const uint32_t wait = due_us_ - micros();
  if (wait <= step_us) {
    delayMicroseconds(static_cast<uint16_t>(wait));
  } else {
    due_us_ = micros();  // somebody took longer than a step
  }
  if (left != 0 || right != 0) ++steps_;
  sensors_.read();
  behind_left_ += left * (kStepMs * 0.001f);
  behind_right_ += right * (kStepMs * 0.001f);
  reckon();
  behind_left_ = limited(behind_left_, MOST_BEHIND);
  behind_right_ = limited(behind_right_, MOST_BEHIND);
  if (left + right >= 0 && (left != 0 || right != 0) && digitalRead(bumper_pin_) == LOW) pause();
}

void LineWalker::reckon() {
  const float per_count = 0.5f * 2 * QUARTER * s_.wheel / s_.periods;
  const float left = encoders_.takeLeft() * per_count, right = encoders_.takeRight() * per_count;
  still_ = left == 0 && right == 0 ? still_ + 1 : 0;
  behind_left_ -= left;
  behind_right_ -= right;
  const float ds = 0.5f * (left + right), turn = (left - right) / s_.track;
  const float mean = off_ + 0.5f * turn;
  advance(ds * (1 - 0.5f * mean * mean), ds * mean * (1 - mean * mean / 6));
  travelled_ += ds;
  turned_ += turn;
  off_ += turn;
  if (fade_ && magnitude(off_) < FADE_BELOW) off_ -= off_ * magnitude(ds) / FADE_MM;
  if (magnitude(off_) <= 0.5f * QUARTER) return;
  const bool clockwise = off_ > 0;
  heading_ = nav::turned(heading_, clockwise ? Turn::right : Turn::left);
  off_ += clockwise ? -QUARTER : QUARTER;
}

void LineWalker::advance(float along, float aside) {
  switch (heading_) {
    case 0:
      x_ += along;
      y_ += aside;
      return;
    case 1:
      x_ -= aside;
      y_ += along;
      return;
    case 2:
      x_ -= along;
      y_ -= aside;
      return;
    default:
      x_ += aside;
      y_ -= along;
  }
}

void LineWalker::drive(float forward, float clockwise) {
  const float change = s_.acceleration * (kStepMs * 0.001f);
  speed_ += limited(forward - speed_, change);
  const float aside = 0.5f * s_.track * clockwise;
  const float left = speed_ + aside, right = speed_ - aside;
  step(left < 0 ? 0 : left, right < 0 ? 0 : right);
}

void LineWalker::brake() {
  speed_ = 0;
  still_ = 0;
  for (uint8_t i = 0; i < 100 && still_ < STILL_STEPS; ++i) step(0, 0);
}

void LineWalker::pause() {
  motors_.stop();
  if (on_pause_) on_pause_(true);
  const uint32_t start = millis();
  uint32_t pressed = start;
  uint32_t now = start;
  while (now - pressed < CLEAR_MS && now - start < s_.patience_ms) {
    delay(1);
    now = millis();
    if (digitalRead(bumper_pin_) == LOW) pressed = now;
  }
  blocked_ = now - pressed < CLEAR_MS;
  if (on_pause_) on_pause_(false);
  reckon();
  behind_left_ = behind_right_ = speed_ = 0;
  due_us_ = micros();
}

bool LineWalker::darkAhead() const { return sensors_.onLine(1) || sensors_.onLine(2) || sensors_.onLine(3); }

bool LineWalker::armAt(uint8_t sensor) const {
  if (!sensors_.onLine(sensor)) return false;
  uint16_t sum = 0;
  for (uint8_t i = 0; i < sensors_.count(); ++i) sum = static_cast<uint16_t>(sum + sensors_.value(i));
  return sum >= LINE_AND_ARM;
}

float LineWalker::offLine() const { return sensors_.position() * 0.001f * s_.pitch; }

bool LineWalker::roll(float to, Roll how) {
  for (;;) {
    const float rest = to - travelled_;
    if (rest <= 1) break;
    const float e = how == Roll::on_line ? offLine() : 0;
    const float brisk = rest > CREEP_FROM ? 0.02f * s_.acceleration * (rest - CREEP_FROM) * 0.3f : 0;
    drive(least(s_.cruise, s_.creeping + brisk), s_.steering * e);
    if (blocked_) return false;
    if (how == Roll::off_line && darkAhead()) return false;
  }
  brake();
  return true;
}

bool LineWalker::turnToLine(float target) {
  fade_ = false;
  const float way = target < 0 ? -1 : 1;
  while (way * (target - turned_) > SEARCH) spin(way * s_.turning);
  for (uint8_t sweep = 0; sweep < 2; ++sweep) {
    const float to = sweep == 0 ? way : -way;
    while (to * (turned_ - target) < SEARCH) {
      spin(to * s_.creeping);
      if (!darkAhead() || to * sensors_.position() > TURN_LEAD) continue;
      brake();
      return true;
    }
    brake();
  }
  return false;
}

void LineWalker::spin(float speed) {
  step(speed, -speed);
  blocked_ = false;
}

bool LineWalker::face(Heading heading, float angle) {
  brake();
  turned_ = 0;
  const bool found = angle == 0 || turnToLine(angle);
  heading_ = heading;
  off_ = 0;
  // It stands on the line that leaves here.
  if (heading & 1) {
    x_ = mark_x_;
  } else {
    y_ = mark_y_;
  }
  return found;
}

void LineWalker::backUp() {
  const float from = travelled_;
  brake();
  while (from - travelled_ < BACK_UP_MM) step(-s_.creeping, -s_.creeping);
  brake();
  blocked_ = false;
}

Landmark LineWalker::landmark(LandmarkKind kind, uint8_t arms) {
  from_line_ = kind == LandmarkKind::line;
  Landmark met;
  met.kind = kind;
  met.arms = arms;
  met.heading = heading_;
  met.at.x = static_cast<int32_t>(mark_x_ < 0 ? mark_x_ - 0.5f : mark_x_ + 0.5f);
  met.at.y = static_cast<int32_t>(mark_y_ < 0 ? mark_y_ - 0.5f : mark_y_ + 0.5f);
  met.cost = steps_ / (20 / kStepMs);
  steps_ = 0;
  return met;
}

Landmark LineWalker::begin() {
  due_us_ = micros();
  fade_ = blocked_ = false;
  encoders_.takeLeft();
  encoders_.takeRight();
  brake();
  turned_ = 0;
  uint8_t arms = 0;
  while (turned_ < 4 * QUARTER - SEARCH) {
    if (sensors_.onLine(2)) {
      const uint8_t quarter = static_cast<uint8_t>(turned_ / QUARTER + 0.5f);
      if (magnitude(turned_ - quarter * QUARTER) < ARM_NEAR) arms |= static_cast<uint8_t>(1 << (quarter & 3));
    }
    spin(s_.turning);
  }
  Heading ahead = 0;
  while (ahead < 3 && !nav::hasArm(arms, ahead)) ++ahead;
  const bool found = arms != 0 && turnToLine((4 + ahead) * QUARTER);
  if (!found) brake();
  heading_ = found ? ahead : 0;
  off_ = x_ = y_ = mark_x_ = mark_y_ = 0;
  steps_ = 0;
  if (!found) return landmark(LandmarkKind::lost, 0);
  const uint8_t count = nav::slotCount(arms);
  return landmark(count == 1   ? LandmarkKind::end
                  : count == 2 ? LandmarkKind::line
                               : LandmarkKind::junction,
                  arms);
}

Landmark LineWalker::follow() {
  due_us_ = micros();
  travelled_ = 0;
  start_heading_ = heading_;
  for (;;) {
    fade_ = true;
    const Met met = run();
    const uint8_t back = static_cast<uint8_t>(1 << nav::opposite(heading_));
    if (met == Met::nothing) continue;
    if (met == Met::junction) return landmark(LandmarkKind::junction, arms_);
    mark_x_ = x_;
    mark_y_ = y_;
    switch (met) {
      case Met::end:
        if (blocked_) backUp();
        return landmark(LandmarkKind::end, back);
      case Met::loop:
        brake();
        return landmark(LandmarkKind::loop, 0);
      case Met::blocked:
        backUp();
        return landmark(LandmarkKind::blocked, back);
      default:
        brake();
        return landmark(LandmarkKind::lost, 0);
    }
  }
}

LineWalker::Met LineWalker::run() {
  float seen = travelled_;
  for (;;) {
    const float e = offLine();
    const float slow = s_.cruise - s_.slowing * magnitude(e);
    drive(slow > s_.creeping ? slow : s_.creeping, s_.steering * e);
    if (blocked_) return Met::blocked;
    if (armAt(0) || armAt(4)) return cross();
    if (sensors_.seesLine()) {
      seen = travelled_;
    } else if (sensors_.position() != 0) {
      if (travelled_ - seen > SIDE_MM) return Met::lost;
    } else if (travelled_ - seen > END_MM) {
      if (roll(seen + s_.sensors_ahead - 0.6f * s_.line, Roll::off_line) || blocked_) return Met::end;
      return Met::nothing;  // a gap
    }
    if (from_line_ && travelled_ > LOOP_LEAST && heading_ == start_heading_ && magnitude(x_) < LOOP_NEAR &&
        magnitude(y_) < LOOP_NEAR)
      return Met::loop;
  }
}

// An arm begins under an outer sensor.
LineWalker::Met LineWalker::cross() {
  const float start = travelled_, length = 1.7f * s_.line;
  Dark left, right;
  while (travelled_ - start < length) {
    left.note(sensors_.onLine(0), travelled_);
    right.note(sensors_.onLine(4), travelled_);
    drive(s_.cruise, 0);
    if (blocked_) return Met::blocked;
  }
  const bool to_left = left.length() > 0.5f * s_.line, to_right = right.length() > 0.5f * s_.line;
  const bool ahead = darkAhead();
  if (!to_left && !to_right) return Met::nothing;
  const float middle = to_left && to_right ? 0.5f * (left.middle() + right.middle())
                       : to_left           ? left.middle()
                                           : right.middle();
  const float centre = middle + s_.sensors_ahead;
  if (!roll(centre, ahead ? Roll::on_line : Roll::straight)) return Met::blocked;
  const float rest = centre - travelled_;
  const float x = x_, y = y_;
  advance(rest, 0);
  mark_x_ = x_;
  mark_y_ = y_;
  x_ = x;
  y_ = y;
  if (!ahead && to_left != to_right) {  // a bend
    const Turn turn = to_left ? Turn::left : Turn::right;
    return face(nav::turned(heading_, turn), to_left ? -QUARTER : QUARTER) ? Met::nothing : Met::lost;
  }
  arms_ = static_cast<uint8_t>(1 << nav::opposite(heading_));
  if (ahead) arms_ |= static_cast<uint8_t>(1 << heading_);
  if (to_left) arms_ |= static_cast<uint8_t>(1 << nav::turned(heading_, Turn::left));
  if (to_right) arms_ |= static_cast<uint8_t>(1 << nav::turned(heading_, Turn::right));
  return ahead || (to_left && to_right) ? Met::junction : Met::nothing;
}

void LineWalker::leave(Turn turn) {
  due_us_ = micros();
  const float angle = turn == Turn::left ? -QUARTER : static_cast<uint8_t>(turn) * QUARTER;
  face(nav::turned(heading_, turn), angle);
  steps_ = 0;
}

void LineWalker::relocate(const nav::Place& at) {
  x_ += at.x - mark_x_;
  y_ += at.y - mark_y_;
  mark_x_ = at.x;
  mark_y_ = at.y;
}
