#include "sim/exec/chip/chip_executor.h"

#include <algorithm>

namespace robosim::exec {

ChipExecutor::ChipExecutor(const BoardSpec& spec, std::unique_ptr<ChipFirmware> firmware)
    : board_(spec), firmware_(std::move(firmware)) {
  std::ranges::copy(firmware_->eeprom(), board_.memory().begin());
}

void ChipExecutor::power_on(SimTime t) {
  power_off(t);
  chip_ = firmware_->power_on(clocked_, clocked_.begin_tick(t));
  if (clock_start_ > 0) chip_->set_clock(clock_start_);
  if (written_) {
    written_->begin([this](const SourceLine& before) { return chip_->printing(before); });
    chip_->trace_bytes(*written_);
  }
}

void ChipExecutor::power_off(SimTime t) {
  before_ = resources();
  chip_.reset();
  crash_.reset();
  board_.reset(t);
  reached_ = t;
}

void ChipExecutor::run_until(SimTime t) {
  if (!chip_ || crash_) return;
  chip_->run_until(clocked_.begin_tick(t));
  reached_ = t;
  if (chip_->has_crashed()) crash_ = chip_->crash();
  board_.forget_edges(t);
}

SimTime ChipExecutor::last_call() const {
  return !chip_ || chip_->is_asleep() ? reached_ : clocked_.to_world(chip_->last_io());
}

std::optional<Resources> ChipExecutor::resources() const {
  if (!firmware_->fits_chip()) return std::nullopt;
  if (!chip_) return before_;
  Resources r = chip_->resources();
  if (before_) {
    r.stack_bytes_max = std::max(r.stack_bytes_max, before_->stack_bytes_max);
    r.loop_us_max = std::max(r.loop_us_max, before_->loop_us_max);
  }
  return r;
}

void ChipExecutor::set_clock_start(SimTime start) {
  const std::string why = firmware_->why_clock_stays();
  if (!why.empty()) throw InputError({firmware_->file()}, "has no clock that could be set (" + why + ")");
  clock_start_ = start;
}

Activity ChipExecutor::activity() {
  Activity activity;
  if (chip_) activity = chip_->activity();
  activity.last_call = chip_ ? clocked_.to_world(chip_->last_io()) : reached_;
  if (crash_) activity.where = crash_->where;
  return activity;
}

}  // namespace robosim::exec
