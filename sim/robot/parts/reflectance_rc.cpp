#include "sim/robot/parts/reflectance_rc.h"

#include <algorithm>
#include <cmath>

namespace robosim::robot {
namespace {

constexpr double kFillRate = 1.0 / 10e3;  // 1/ns: full in 10 us
constexpr double kThreshold = 0.5;        // share of the supply; an input's threshold

}  // namespace

RcSensor::RcSensor(const ReflectanceSpec& spec, const ReflectanceSpec::Element& element,
                   const PartContext& context, const Emitter& emitter)
    : Sensor(spec, element, context, emitter),
      white_rate_(1.0 / context.sampler.draw(element.white, name(), "white_time")),
      black_rate_(1.0 / context.sampler.draw(element.black, name(), "black_time")) {
  context.snapshots.add(state_);
}

void RcSensor::connect(PartContext& context, Pin pin) {
  RobotPort& board = context.board;
  board_ = &board;
  pin_ = pin;
  board.connect(pin, *this);
  board.watch(pin, *this);
}

double RcSensor::charge(SimTime t) const {
  return std::clamp(state_.charge + state_.slope * static_cast<double>(t - state_.since), 0.0, 1.0);
}

void RcSensor::pin_changed(Pin, const PinDrive& drive, SimTime t) {
  const bool driven = drive.mode == PinMode::output;
  if (!driven && !state_.driven) return;
  state_.driven = driven;
  state_.charge = charge(t);
  state_.since = t;
  state_.announced = true;
  if (driven) {
    state_.slope = drive.level ? kFillRate : -kFillRate;
    state_.falls_at = drive.level ? kNever : t;
    return;
  }
  const double b = blackness(t);
  const double rate = stuck() ? 1e6 / std::max(stuck_at(), 1.0)
                              : std::max(black_rate_ * b + white_rate_ * (1.0 - b), 0.1 * black_rate_);
  state_.slope = -(1.0 - kThreshold) * rate * 1e-9;
  state_.falls_at =
      t + static_cast<SimTime>(std::ceil(std::max(state_.charge - kThreshold, 0.0) / -state_.slope));
  state_.announced = state_.falls_at <= t;
  announce(t, context_.view.tick_start + kTick);
}

void RcSensor::begin_tick(SimTime t) {
  if (!state_.announced) announce(t, t + kTick);
}

void RcSensor::announce(SimTime from, SimTime to) {
  if (state_.announced || state_.falls_at >= to) return;
  state_.announced = true;
  if (board_->wants_edges(pin_)) board_->schedule_edge(pin_, false, std::max(state_.falls_at, from));
}

double RcSensor::stuck_blackness() const {
  return (1e6 / std::max(stuck_at(), 1.0) - white_rate_) / (black_rate_ - white_rate_);
}

}  // namespace robosim::robot
