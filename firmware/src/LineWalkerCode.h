// The code of LineWalker.h, which includes it: a template's code must be in a header.
#ifndef LINEKIT_LINE_WALKER_CODE_H
#define LINEKIT_LINE_WALKER_CODE_H

#include "LineWalker.h"
#include "LineWalkerParts.h"

template <class S>
void LineWalkerOf<S>::setup() {
  sensors_.begin();
  encoders_.begin();
  motors_.setSmallestDuty(S::smallest_duty);
  motors_.begin();
  pinMode(bumper_pin_, INPUT_PULLUP);
}

template <class S>
void LineWalkerOf<S>::step(float left, float right) {
  if (left == 0 && right == 0) behind_left_ = behind_right_ = 0;
  const int16_t left_duty =
      line_walker::dutyOf(left, left * S::duty_per_speed + behind_left_ * S::duty_per_mm);
  const int16_t right_duty =
      line_walker::dutyOf(right, right * S::duty_per_speed + behind_right_ * S::duty_per_mm);
  encoders_.setDirections(left_duty, right_duty);
  motors_.drive(left_duty, right_duty);

  const uint32_t step_us = 1000UL * kStepMs;
  due_us_ += step_us;
  const uint32_t wait = due_us_ - micros();
  if (wait <= step_us) {
    delayMicroseconds(static_cast<uint16_t>(wait));
  } else {
    due_us_ = micros();  // something took longer than a step
  }
  if (left != 0 || right != 0) ++steps_;
  sensors_.read();
  behind_left_ += left * (kStepMs * 0.001f);
  behind_right_ += right * (kStepMs * 0.001f);
  reckon();
  behind_left_ = line_walker::limited(behind_left_, line_walker::kMostBehind);
  behind_right_ = line_walker::limited(behind_right_, line_walker::kMostBehind);
  if (left + right >= 0 && (left != 0 || right != 0) && !deaf_ && digitalRead(bumper_pin_) == LOW) pause();
}

template <class S>
void LineWalkerOf<S>::reckon() {
  const float per_count = 0.5f * 2 * line_walker::kQuarter * S::wheel / S::periods;
  const float left = encoders_.takeLeft() * per_count, right = encoders_.takeRight() * per_count;
  still_ = left == 0 && right == 0 ? still_ + 1 : 0;
  behind_left_ -= left;
  behind_right_ -= right;
  const float ds = 0.5f * (left + right), turn = (left - right) / S::track;
  const float mean = off_ + 0.5f * turn;
  advance(ds * (1 - 0.5f * mean * mean), ds * mean * (1 - mean * mean / 6));
  travelled_ += ds;
  turned_ += turn;
  off_ += turn;
  if (fade_ && line_walker::magnitude(off_) < line_walker::kFadeBelow)
    off_ -= off_ * line_walker::magnitude(ds) / line_walker::kFadeMm;
  if (line_walker::magnitude(off_) <= 0.5f * line_walker::kQuarter) return;
  const bool clockwise = off_ > 0;
  heading_ = nav::turned(heading_, clockwise ? nav::Turn::right : nav::Turn::left);
  off_ += clockwise ? -line_walker::kQuarter : line_walker::kQuarter;
}

template <class S>
void LineWalkerOf<S>::advance(float along, float aside) {
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

template <class S>
void LineWalkerOf<S>::drive(float forward, float clockwise) {
  const float change = S::acceleration * (kStepMs * 0.001f);
  speed_ += line_walker::limited(forward - speed_, change);
  const float aside = 0.5f * S::track * clockwise;
  const float left = speed_ + aside, right = speed_ - aside;
  step(left < 0 ? 0 : left, right < 0 ? 0 : right);
}

template <class S>
void LineWalkerOf<S>::brake() {
  speed_ = 0;
  still_ = 0;
  for (uint8_t i = 0; i < 100 && still_ < line_walker::kStillSteps; ++i) step(0, 0);
}

template <class S>
void LineWalkerOf<S>::pause() {
  motors_.stop();
  if (on_pause_) on_pause_(true);
  const uint32_t start = millis();
  uint32_t pressed = start;
  uint32_t now = start;
  while (now - pressed < line_walker::kClearMs && now - start < S::patience_ms) {
    delay(1);
    now = millis();
    if (digitalRead(bumper_pin_) == LOW) pressed = now;
  }
  blocked_ = now - pressed < line_walker::kClearMs;
  if (!blocked_ && on_pause_) on_pause_(false);
  reckon();
  behind_left_ = behind_right_ = speed_ = 0;
  due_us_ = micros();
}

template <class S>
bool LineWalkerOf<S>::darkAhead() const {
  return sensors_.onLine(1) || sensors_.onLine(2) || sensors_.onLine(3);
}

template <class S>
bool LineWalkerOf<S>::armAt(uint8_t sensor) const {
  if (!sensors_.onLine(sensor)) return false;
  uint16_t sum = 0;
  for (uint8_t i = 0; i < sensors_.count(); ++i) sum = static_cast<uint16_t>(sum + sensors_.value(i));
  return sum >= line_walker::kLineAndArm;
}

template <class S>
float LineWalkerOf<S>::offLine() const {
  return sensors_.position() * 0.001f * S::pitch;
}

template <class S>
bool LineWalkerOf<S>::roll(float to, Roll how) {
  for (;;) {
    const float rest = to - travelled_;
    if (rest <= 1) break;
    const float e = how == Roll::on_line ? offLine() : 0;
    const float brisk = rest > line_walker::kCreepFrom
                            ? 0.02f * S::acceleration * (rest - line_walker::kCreepFrom) * 0.3f
                            : 0;
    drive(line_walker::least(S::cruise, S::creeping + brisk), S::steering * e);
    if (blocked_) return false;
    if (how == Roll::off_line && darkAhead()) return false;
  }
  brake();
  return true;
}

template <class S>
bool LineWalkerOf<S>::turnToLine(float target) {
  fade_ = false;
  const float way = target < 0 ? -1 : 1;
  while (way * (target - turned_) > line_walker::kSearch) spin(way * S::turning);
  for (uint8_t sweep = 0; sweep < 2; ++sweep) {
    const float to = sweep == 0 ? way : -way;
    while (to * (turned_ - target) < line_walker::kSearch) {
      spin(to * S::creeping);
      if (!darkAhead() || to * sensors_.position() > line_walker::kTurnLead) continue;
      brake();
      return true;
    }
    brake();
  }
  while (way * (target - turned_) > line_walker::kTurnedEarly) spin(way * S::creeping);
  brake();
  return false;
}

template <class S>
void LineWalkerOf<S>::spin(float speed) {
  step(speed, -speed);
  blocked_ = false;
}

template <class S>
bool LineWalkerOf<S>::face(nav::Heading heading, float angle) {
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

template <class S>
void LineWalkerOf<S>::backUp(float distance) {
  const float to = travelled_ - distance;
  brake();
  while (travelled_ > to) step(-S::creeping, -S::creeping);
  brake();
  blocked_ = false;
}

template <class S>
bool LineWalkerOf<S>::backUpToPassed() {
  const float distance = travelled_ - passed_at_;
  if (passed_ == Passed::nothing || distance > S::sensors_ahead + line_walker::kNearMm) return false;
  backUp(distance);
  x_ = mark_x_;
  y_ = mark_y_;
  off_ = 0;
  return returned_ = true;
}

template <class S>
nav::Landmark LineWalkerOf<S>::landmark(nav::LandmarkKind kind, uint8_t arms) {
  from_line_ = kind == nav::LandmarkKind::line;
  if (kind == nav::LandmarkKind::end || kind == nav::LandmarkKind::junction) {
    passed_ = Passed::landmark;
    passed_kind_ = kind;
    passed_arms_ = arms;
  } else if (!returned_) {
    passed_ = Passed::nothing;
  }
  nav::Landmark met;
  met.kind = kind;
  met.arms = arms;
  met.heading = heading_;
  met.at.x = static_cast<int32_t>(mark_x_ < 0 ? mark_x_ - 0.5f : mark_x_ + 0.5f);
  met.at.y = static_cast<int32_t>(mark_y_ < 0 ? mark_y_ - 0.5f : mark_y_ + 0.5f);
  met.cost = steps_ / (20 / kStepMs);
  steps_ = 0;
  return met;
}

template <class S>
nav::Landmark LineWalkerOf<S>::begin() {
  due_us_ = micros();
  fade_ = blocked_ = false;
  encoders_.takeLeft();
  encoders_.takeRight();
  brake();
  turned_ = 0;
  uint8_t arms = 0;
  while (turned_ < 4 * line_walker::kQuarter - line_walker::kSearch) {
    if (sensors_.onLine(2)) {
      const uint8_t quarter = static_cast<uint8_t>(turned_ / line_walker::kQuarter + 0.5f);
      if (line_walker::magnitude(turned_ - quarter * line_walker::kQuarter) < line_walker::kArmNear)
        arms |= static_cast<uint8_t>(1 << (quarter & 3));
    }
    spin(S::turning);
  }
  nav::Heading ahead = 0;
  while (ahead < 3 && !nav::hasArm(arms, ahead)) ++ahead;
  const bool found = arms != 0 && turnToLine((4 + ahead) * line_walker::kQuarter);
  if (!found) brake();
  heading_ = found ? ahead : 0;
  off_ = x_ = y_ = mark_x_ = mark_y_ = 0;
  steps_ = 0;
  if (!found) return landmark(nav::LandmarkKind::lost, 0);
  const uint8_t count = nav::slotCount(arms);
  if (count > 2 && ahead != 0) {  // on a junction, facing no line: as it stood
    turned_ = ahead * line_walker::kQuarter;
    while (turned_ > line_walker::kTurnedEarly) spin(-S::turning);
    brake();
    heading_ = 0;
    off_ = 0;
  }
  return landmark(count == 1   ? nav::LandmarkKind::end
                  : count == 2 ? nav::LandmarkKind::line
                               : nav::LandmarkKind::junction,
                  arms);
}

template <class S>
nav::Landmark LineWalkerOf<S>::follow() {
  if (returned_ && passed_ == Passed::landmark) {
    returned_ = false;
    return landmark(passed_kind_, passed_arms_);
  }
  if (returned_) passed_ = Passed::nothing;
  returned_ = false;
  due_us_ = micros();
  travelled_ = passed_at_ = 0;
  start_heading_ = heading_;
  for (;;) {
    fade_ = true;
    const Met met = run();
    const uint8_t back = static_cast<uint8_t>(1 << nav::opposite(heading_));
    if (met == Met::nothing) continue;
    if (met == Met::junction) return landmark(nav::LandmarkKind::junction, arms_);
    if (met == Met::blocked && backUpToPassed()) return landmark(nav::LandmarkKind::blocked, back);
    mark_x_ = x_;
    mark_y_ = y_;
    switch (met) {
      case Met::end:
        if (blocked_) backUp(line_walker::kBackUpMm);
        return landmark(nav::LandmarkKind::end, back);
      case Met::loop:
        brake();
        return landmark(nav::LandmarkKind::loop, 0);
      case Met::blocked:
        backUp(line_walker::kBackUpMm);
        return landmark(nav::LandmarkKind::blocked, back);
      default:
        brake();
        return landmark(nav::LandmarkKind::lost, 0);
    }
  }
}

template <class S>
typename LineWalkerOf<S>::Met LineWalkerOf<S>::run() {
  float seen = travelled_;
  for (;;) {
    const float e = offLine();
    const float slow = S::cruise - S::slowing * line_walker::magnitude(e);
    drive(slow > S::creeping ? slow : S::creeping, S::steering * e);
    if (blocked_) return Met::blocked;
    if (armAt(0) || armAt(4)) return cross();
    if (sensors_.seesLine()) {
      seen = travelled_;
    } else if (sensors_.position() != 0) {
      if (travelled_ - seen > line_walker::kSideMm) return Met::lost;
    } else if (travelled_ - seen > line_walker::kEndMm) {
      if (roll(seen + S::sensors_ahead - 0.6f * S::line, Roll::off_line) || blocked_) return Met::end;
      return Met::nothing;  // a gap
    }
    if (from_line_ && travelled_ > line_walker::kLoopLeast && heading_ == start_heading_ &&
        line_walker::magnitude(x_) < line_walker::kLoopNear &&
        line_walker::magnitude(y_) < line_walker::kLoopNear)
      return Met::loop;
  }
}

// An arm begins under an outer sensor.
template <class S>
typename LineWalkerOf<S>::Met LineWalkerOf<S>::cross() {
  const float start = travelled_, length = 1.7f * S::line;
  line_walker::Dark left, right;
  while (travelled_ - start < length) {
    left.note(sensors_.onLine(0), travelled_);
    right.note(sensors_.onLine(4), travelled_);
    drive(S::cruise, 0);
    if (blocked_) return Met::blocked;
  }
  const bool to_left = left.length() > 0.5f * S::line, to_right = right.length() > 0.5f * S::line;
  const bool ahead = darkAhead();
  if (!to_left && !to_right) return Met::nothing;
  const float middle = to_left && to_right ? 0.5f * (left.middle() + right.middle())
                       : to_left           ? left.middle()
                                           : right.middle();
  const float centre = middle + S::sensors_ahead;
  if (!roll(centre, ahead ? Roll::on_line : Roll::straight)) return Met::blocked;
  const float rest = centre - travelled_;
  const float x = x_, y = y_;
  advance(rest, 0);
  mark_x_ = x_;
  mark_y_ = y_;
  x_ = x;
  y_ = y;
  if (!ahead && to_left != to_right) {  // a bend
    const nav::Turn turn = to_left ? nav::Turn::left : nav::Turn::right;
    passed_ = Passed::corner;
    passed_heading_ = heading_;
    const bool found =
        face(nav::turned(heading_, turn), to_left ? -line_walker::kQuarter : line_walker::kQuarter);
    passed_at_ = travelled_;
    return found ? Met::nothing : Met::lost;
  }
  arms_ = static_cast<uint8_t>(1 << nav::opposite(heading_));
  if (ahead) arms_ |= static_cast<uint8_t>(1 << heading_);
  if (to_left) arms_ |= static_cast<uint8_t>(1 << nav::turned(heading_, nav::Turn::left));
  if (to_right) arms_ |= static_cast<uint8_t>(1 << nav::turned(heading_, nav::Turn::right));
  return ahead || (to_left && to_right) ? Met::junction : Met::nothing;
}

template <class S>
void LineWalkerOf<S>::leave(nav::Turn turn) {
  due_us_ = micros();
  deaf_ = returned_ || passed_ == Passed::nothing;  // after `blocked`
  if (returned_ && passed_ == Passed::corner)
    turn = nav::turnBetween(heading_, nav::opposite(passed_heading_));
  const float angle =
      turn == nav::Turn::left ? -line_walker::kQuarter : static_cast<uint8_t>(turn) * line_walker::kQuarter;
  face(nav::turned(heading_, turn), angle);
  deaf_ = false;
  steps_ = 0;
}

template <class S>
void LineWalkerOf<S>::relocate(const nav::Place& at) {
  x_ += at.x - mark_x_;
  y_ += at.y - mark_y_;
  mark_x_ = at.x;
  mark_y_ = at.y;
}

#endif
