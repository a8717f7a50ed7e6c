#include "sim/robot/parts/reflectance_rc.h"

#include <algorithm>
#include <cmath>

namespace robosim::robot {
namespace {

constexpr double kFillRate = 1.0 / 10e3;  // 1/ns: full in 10 us
constexpr double kThreshold = 0.5;        // of the supply, at which an input falls

}  // namespace

RcSensor::RcSensor(const ReflectanceSpec& spec, const ReflectanceSpec::Element& element,
                   const PartContext& context, const Emitter& emitter)
    : Sensor(spec, element, context, emitter), supply_(context.description.board->supply_volts) {
  white_rate_ = 1.0 / context.individual.draw(spec.white_time, name(), "white_time");
  black_rate_ = 1.0 / context.individual.draw(spec.black_time, name(), "black_time");
}

void RcSensor::join(RobotPort& board, Pin pin) {
  board_ = &board;
  pin_ = pin;
  board.connect(pin, *this);
  board.watch(pin, *this);
}

double RcSensor::charge(SimTime t) const {
  return std::clamp(charge_ + slope_ * static_cast<double>(t - since_), 0.0, 1.0);
}

void RcSensor::pin_changed(Pin, const PinDrive& drive, SimTime t) {
  const bool driven = drive.mode == PinMode::output;
  if (!driven && !driven_) return;
  driven_ = driven;
  charge_ = charge(t);
  since_ = t;
  announced_ = true;
  if (driven) {
    slope_ = drive.level ? kFillRate : -kFillRate;
    falls_at_ = drive.level ? kNever : t;
    return;
  }
  const double b = blackness(t);
  const double rate = stuck() ? 1e6 / std::max(stuck_at(), 1.0)
                              : std::max(black_rate_ * b + white_rate_ * (1.0 - b), 0.1 * black_rate_);
  slope_ = -(1.0 - kThreshold) * rate * 1e-9;
  falls_at_ = t + static_cast<SimTime>(std::ceil(std::max(charge_ - kThreshold, 0.0) / -slope_));
  announced_ = falls_at_ <= t;
  announce(t, context_.view.tick_start + kTick);
}

void RcSensor::begin_tick(SimTime t) {
  if (!announced_) announce(t, t + kTick);
}

void RcSensor::announce(SimTime from, SimTime to) {
  if (announced_ || falls_at_ >= to) return;
  announced_ = true;
  if (board_->wants_edges(pin_)) board_->schedule_edge(pin_, false, std::max(falls_at_, from));
}

double RcSensor::volts(SimTime t) { return charge(t) * supply_; }

double RcSensor::stuck_blackness() const {
  return (1e6 / std::max(stuck_at(), 1.0) - white_rate_) / (black_rate_ - white_rate_);
}

}  // namespace robosim::robot
