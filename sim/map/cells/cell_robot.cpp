#include "sim/map/cells/cell_robot.h"

namespace robosim::cells {

const char* name_of(Move move) {
  static constexpr const char* kNames[] = {"step_forward", "turn_right",   "turn_left",
                                           "turn_around",  "choose_right", "choose_left"};
  return kNames[static_cast<int>(move)];
}

void CellRobot::set_noise(const CellNoise& noise) {
  miss_ = noise.miss;
  slip_ = noise.slip;
  misses_ = NoiseStream(noise.seed, 0, "cells", "miss");
  slips_ = NoiseStream(noise.seed, 0, "wheels", "slip");
  noisy_ = noise.miss > 0.0 || noise.slip > 0.0;
  set_free();
}

bool CellRobot::begin_asking(Move move) {
  if (moves_ >= limit_) throw OutOfMoves();
  ++moves_;
  if (watcher_) watcher_->moved(pose(), sense(), move, clock());
  return !noisy_ || !slips();
}

Sense CellRobot::sense_with_noise() const {
  if (misses_.uniform(2 * moves_) >= miss_) return floor_.sense(at_, facing_);
  return floor_.sense_without(at_, facing_, static_cast<unsigned>(misses_.bits(2 * moves_ + 1) & 3));
}

bool CellRobot::slips() const { return slips_.uniform(moves_) < slip_; }

}  // namespace robosim::cells
