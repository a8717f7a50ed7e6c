#include "sim/detect/floor_reads.h"

#include <algorithm>

#include "hal/board/board_spec.h"

namespace robosim::detect {

FloorReads::FloorReads(const robot::Robot& robot, exec::Executor& executor) : executor_(executor) {
  for (const robot::WiredPin& wired : robot.wiring()) {
    if (!wired.type.starts_with("reflectance") || wired.role.starts_with("emitter")) continue;
    if (wired.pin >= executor.board().spec().pin_count) {
      pins_.clear();
      return;
    }
    pins_.push_back(wired.pin);
  }
}

SimTime FloorReads::last(SimTime now) const {
  SimTime last = -1;
  const exec::BoardProbe& probe = executor_.probe();
  for (const Pin pin : pins_) {
    const exec::PinUse& use = probe.use(pin);
    last = std::max(last, use.awaited && !can_capture(executor_.board().spec(), pin) ? now : use.last_seen);
  }
  return last;
}

}  // namespace robosim::detect
