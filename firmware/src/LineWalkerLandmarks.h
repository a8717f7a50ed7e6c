// Implements the functions of LineWalker.h that drive from landmark to landmark, and recognise landmarks.
// LineWalker.h includes this file.
#ifndef LINEKIT_LINE_WALKER_LANDMARKS_H
#define LINEKIT_LINE_WALKER_LANDMARKS_H

#include "LineWalkerParts.h"

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
  if (count > 2 && ahead != 0) {  // a junction without a line ahead: turns back to the initial heading
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
  deaf_ = returned_ || passed_ == Passed::nothing;  // that is, after `blocked`
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
