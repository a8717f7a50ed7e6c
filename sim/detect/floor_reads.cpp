#include "sim/detect/floor_reads.h"

#include <algorithm>

#include "hal/board/board_spec.h"

namespace robosim::detect {
namespace {

// Returns whether a timer can capture the pin's edges. As soon as firmware reads the timer's flags, the timer
// awaits these edges, even if nothing uses the captures. The Servo library reads the flags.
bool can_capture(const BoardSpec& board, Pin pin) {
  const BoardSpec& model = host_model(board);  // has the registers on the host
  return board.pins[pin].chip_pin.captured_by >= 0 ||
         (pin < model.pin_count && model.pins[pin].chip_pin.captured_by >= 0);
}

}  // namespace

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
