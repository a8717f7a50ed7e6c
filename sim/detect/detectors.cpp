#include "sim/detect/detectors.h"

#include "sim/detect/blind_driving.h"
#include "sim/detect/doubtful_actions.h"
#include "sim/detect/driven_input.h"
#include "sim/detect/eeprom_wear.h"
#include "sim/detect/floating_input.h"
#include "sim/detect/forgotten_output.h"
#include "sim/detect/motors_left_on.h"
#include "sim/detect/overwritten_record.h"
#include "sim/detect/slow_control.h"
#include "sim/detect/slow_serial.h"
#include "sim/detect/torn_record.h"

namespace robosim::detect {
namespace {

/// Returns the pins on which every edge matters: the pins of encoders and infrared receivers.
std::vector<Pin> counted_pins(const robot::Robot& robot) {
  std::vector<Pin> pins;
  for (const robot::WiredPin& wired : robot.wiring())
    if (wired.type == "encoder" || wired.type == "ir-receiver") pins.push_back(wired.pin);
  return pins;
}

}  // namespace

Detectors::Detectors(const robot::Robot& robot, exec::Executor& executor, double line_m)
    : executor_(executor), floor_(robot, executor) {
  if (exec::ChipAccess* const chip = executor.chip_access()) chip->detect(counted_pins(robot));
  snapshots_.add(state_);
  if (floor_.are_known())
    steering_ = {&add<BlindDriving>(robot.sensor_midpoint().x, line_m), &add<MotorsLeftOn>(),
                 &add<SlowSerial>(), &add<SlowControl>()};
  add<ForgottenOutput>(robot.wiring());
  add<DrivenInput>(robot.wiring());
  add<FloatingInput>(robot.wiring());
  add<DoubtfulActionsOnHost>();
  add<EepromWear>();
  add<TornRecord>();
  add<OverwrittenRecord>();
}

void Detectors::booted(std::uint64_t times) {
  if (times == state_.boots) return;
  state_.boots = times;
  for (const auto& detector : all_) detector->powered_on();
}

void Detectors::look(Steering now) {
  if (steering_.empty()) return;
  now.asks_floor = floor_.last(now.t) >= state_.before;
  state_.before = now.t;
  for (SteeringDetector* const detector : steering_) detector->look(now);
}

std::vector<exec::Detected> Detectors::found(SimTime now) const {
  exec::ChipAccess* const chip = executor_.chip_access();
  std::vector<exec::Detected> all = chip ? chip->detected() : std::vector<exec::Detected>{};
  for (const auto& detector : all_)
    for (exec::Detected& one : detector->found(now)) all.push_back(std::move(one));
  return all;
}

}  // namespace robosim::detect
