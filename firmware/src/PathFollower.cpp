#include "PathFollower.h"

PathFollower::Exit PathFollower::choose(Side prefer, bool left, bool ahead, bool right) {
  if (prefer == Side::left ? left : right) return prefer == Side::left ? Exit::left : Exit::right;
  if (ahead) return Exit::ahead;
  if (left) return Exit::left;
  if (right) return Exit::right;
  return Exit::back;
}

void PathFollower::update(bool left, bool middle, bool right, uint32_t now_ms) {
  const uint32_t step = started_ ? now_ms - now_ : 0;
  step_ = step < 100 ? static_cast<uint16_t>(step) : 100;
  now_ = now_ms;
  if (!started_) {
    started_ = true;
    entered_ = now_ms;
  }
  switch (state_) {
    case State::following:
      follow(left, middle, right);
      break;
    case State::crossing:
      cross(left, middle, right);
      break;
    case State::ending:
    case State::peeking:
      end(left, middle, right);
      break;
    case State::leaving:
    case State::turning:
      turn(left, middle, right);
      break;
  }
}

void PathFollower::enter(State state) {
  state_ = state;
  entered_ = now_;
  lost_ = 0;
}

void PathFollower::drive(int16_t left, int16_t right) {
  left_speed_ = left;
  right_speed_ = right;
}

void PathFollower::spin(Side side) {
  if (side == Side::left) {
    drive(-settings_.turn, settings_.turn);
  } else {
    drive(settings_.turn, -settings_.turn);
  }
}

void PathFollower::follow(bool left, bool middle, bool right) {
  if ((left && middle) || (right && middle) || (left && right)) {
    left_seen_ = right_seen_ = ahead_seen_ = 0;
    enter(State::crossing);
    cross(left, middle, right);
    return;
  }
  if (middle) line_side_ = 0;
  if (left) line_side_ = -1;
  if (right) line_side_ = 1;
  if (line_side_ == 0) {
    drive(settings_.cruise, settings_.cruise);
  } else if (line_side_ < 0) {
    drive(settings_.correct_inner, settings_.correct_outer);
  } else {
    drive(settings_.correct_outer, settings_.correct_inner);
  }
  const bool nothing = !left && !middle && !right;
  lost_ = nothing ? lost_ + step_ : 0;
  if (nothing && lost_ >= settings_.noise_ms && line_side_ == 0) enter(State::ending);
}

void PathFollower::cross(bool left, bool middle, bool right) {
  const uint32_t elapsed = now_ - entered_;
  if (elapsed < settings_.pass_ms) {
    if (left && middle) left_seen_ += step_;
    if (right && middle) right_seen_ += step_;
    drive(settings_.cruise, settings_.cruise);
    return;
  }
  if (left || middle || right) ahead_seen_ += step_;
  if (left != right) {
    const int16_t inner = settings_.correct_inner, outer = settings_.correct_outer;
    drive(left ? inner : outer, left ? outer : inner);
  } else {
    drive(settings_.cruise, settings_.cruise);
  }
  if (elapsed < settings_.roll_ms) return;

  const bool branch_left = left_seen_ >= settings_.noise_ms;
  const bool branch_right = right_seen_ >= settings_.noise_ms;
  const bool ahead = ahead_seen_ >= settings_.noise_ms;
  line_side_ = 0;
  if (!branch_left && !branch_right) {
    enter(State::following);
    return;
  }
  ++crossings_;
  const Exit exit = choose(prefer_, branch_left, ahead, branch_right);
  if (exit == Exit::left || exit == Exit::right) {
    startTurn(exit == Exit::left ? Side::left : Side::right);
  } else {
    enter(State::following);
  }
}

void PathFollower::end(bool left, bool middle, bool right) {
  if (left || middle || right) {
    enter(State::following);
    follow(left, middle, right);
    return;
  }
  const uint32_t elapsed = now_ - entered_;
  if (state_ == State::ending) {
    drive(settings_.cruise, settings_.cruise);
    if (elapsed >= settings_.end_ms) {
      enter(State::peeking);
      spin(prefer_ == Side::left ? Side::right : Side::left);
    }
  } else if (elapsed >= settings_.peek_ms) {
    ++stations_;
    enter(State::turning);
    turn_side_ = prefer_;
    spin(turn_side_);
  }
}

void PathFollower::startTurn(Side side) {
  enter(State::leaving);
  turn_side_ = side;
  spin(side);
}

void PathFollower::turn(bool left, bool middle, bool right) {
  spin(turn_side_);
  if (state_ == State::leaving) {
    if (now_ - entered_ >= settings_.leave_ms && !middle) enter(State::turning);
    return;
  }
  if (middle) {
    line_side_ = 0;
    enter(State::following);
    follow(left, middle, right);
  }
}
