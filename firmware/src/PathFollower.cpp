#include "PathFollower.h"

void PathFollower::update(bool left, bool middle, bool right, uint32_t now_ms) {
  const uint32_t step = started_ ? now_ms - now_ : 0;
  if (!started_) entered_ = now_ms;
  started_ = true;
  step_ = step < 100 ? static_cast<uint16_t>(step) : 100;
  now_ = now_ms;
  const bool near = prefer_ == Side::left ? left : right;
  const bool far = prefer_ == Side::left ? right : left;
  near_ms_ = near ? near_ms_ + step_ : 0;
  switch (state_) {
    case State::following:
      return follow(near, middle, far);
    case State::crossing:
      return cross(near);
    case State::rolling:
      return roll(middle, far);
    case State::stopping:
      return stop();
    case State::turning:
      return turn(middle);
    case State::settling:
      return settle();
  }
}

void PathFollower::enter(State state) {
  state_ = state;
  entered_ = now_;
  nothing_ms_ = 0;
}

void PathFollower::drive(int16_t speed, int16_t turn) {
  const int16_t leftward = prefer_ == Side::left ? turn : -turn;
  left_speed_ = speed - leftward;
  right_speed_ = speed + leftward;
}

void PathFollower::follow(bool near, bool middle, bool far) {
  const int16_t mean = (settings_.fast + settings_.slow) / 2;
  const int16_t steer = (settings_.fast - settings_.slow) / 2;
  drive(mean, middle ? steer : -steer);

  if (!near) armed_ = true;
  if (armed_ && near_ms_ >= settings_.noise_ms) {
    enter(State::crossing);
    drive(settings_.cruise, 0);
    return;
  }
  nothing_ms_ = middle || far ? 0 : nothing_ms_ + step_;
  if (nothing_ms_ < timeFor(settings_.end_tenths)) return;
  to_branch_ = false;
  enter(State::rolling);
  drive(settings_.cruise, 0);
}

void PathFollower::cross(bool near) {
  const uint16_t dark_ms = since() + settings_.noise_ms;
  if (near) {
    // A branch soon passes. If the sensor stays dark, the robot has drifted: the sensor is over the line.
    if (dark_ms > 3 * width_ms_) enter(State::following);
    return;
  }
  if (dark_ms >= width_ms_ / 2 && dark_ms <= 2 * width_ms_) width_ms_ = dark_ms;
  to_branch_ = true;
  enter(State::rolling);
}

void PathFollower::roll(bool middle, bool far) {
  if (!to_branch_ && (middle || far)) {
    enter(State::following);
    return;
  }
  if (since() < timeFor(to_branch_ ? settings_.branch_tenths : settings_.past_tenths)) return;
  ++(to_branch_ ? branches_ : ends_);
  enter(State::stopping);
  stop();
}

void PathFollower::stop() {
  drive(-settings_.counter, 0);
  if (since() < settings_.stop_ms) return;
  off_line_ = false;
  enter(State::turning);
}

void PathFollower::turn(bool middle) {
  drive(0, to_branch_ ? settings_.turn : -settings_.turn);
  if (!middle && since() >= settings_.leave_ms) off_line_ = true;
  if (!middle || (to_branch_ && !off_line_)) return;
  enter(State::settling);
  settle();
}

void PathFollower::settle() {
  drive(0, to_branch_ ? -settings_.counter : settings_.counter);
  if (since() < settings_.settle_ms) return;
  armed_ = false;
  enter(State::following);
}
