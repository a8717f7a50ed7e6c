// Implements the steps, odometry and turns of LineWalker.h. That header includes this file, because template
// code must be in a header.
#ifndef LINEKIT_LINE_WALKER_DRIVING_H
#define LINEKIT_LINE_WALKER_DRIVING_H

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
  // The robot stands on the line that leaves the last landmark in the new heading.
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

#endif
