#include "sim/run/board_detectors.h"

#include <utility>

namespace robosim::run {

BoardDetectors::BoardDetectors(exec::Executor& executor, const std::vector<robot::WiredPin>& wiring)
    : executor_(executor),
      state_{.outputs = {executor.board().spec(), wiring},
             .pwm = judge::LostPwm(executor.board().spec()),
             .sources = judge::SlowSource(executor.board().spec())} {
  RobotPort& board = executor.board();
  for (Pin pin = 0; pin < board.spec().pin_count; ++pin) board.watch(pin, *this);
  board.watch_eeprom(*this);
  board.watch_adc(*this);
}

void BoardDetectors::booted(std::uint64_t times) {
  if (times == state_.boots) return;
  state_.boots = times;
  state_.wear.powered_on();
  state_.records.powered_on();
  state_.overwritten.powered_on();
}

void BoardDetectors::pin_changed(Pin pin, const PinDrive& drive, SimTime t) {
  state_.outputs.pin_changed(pin, drive, t, executor_);
  state_.pwm.pin_changed(pin, drive, t, executor_);
}

void BoardDetectors::eeprom_written(std::uint16_t address, std::uint8_t before, std::uint8_t value,
                                    SimTime t) {
  state_.wear.written(address, before, value, t, executor_);
  state_.records.written(address, before, value, t, executor_);
  state_.overwritten.written(address, before, value, t, executor_);
}

void BoardDetectors::converted(Pin pin, double volts, SimTime t) {
  state_.sources.converted(pin, volts, t, executor_);
}

std::vector<exec::Detected> BoardDetectors::found(SimTime now) const {
  std::vector<exec::Detected> all = state_.outputs.found(now);
  for (auto&& some : {state_.pwm.found(), state_.sources.found(), state_.wear.found(), state_.records.found(),
                      state_.overwritten.found()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

}  // namespace robosim::run
