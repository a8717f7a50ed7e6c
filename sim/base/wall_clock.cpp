#include "sim/base/wall_clock.h"

#include <ctime>

namespace robosim {

std::int64_t wall_us() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * std::int64_t{1'000'000} + now.tv_nsec / 1000;
}

}  // namespace robosim
