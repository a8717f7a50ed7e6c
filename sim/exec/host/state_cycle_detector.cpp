#include "sim/exec/host/state_cycle_detector.h"

namespace robosim::exec {

void StateCycleDetector::begin() {
  place_ = nullptr;
  power_ = 1;
  since_ = 0;
}

bool StateCycleDetector::sees(const void* place, Memory stack) {
  if (place == place_ && state_.is_like(heap_, stack)) return true;
  if (place_ && ++since_ < power_) return false;
  power_ *= 2;
  since_ = 0;
  place_ = place;
  state_.take(heap_, stack);
  return false;
}

}  // namespace robosim::exec
