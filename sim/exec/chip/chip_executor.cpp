#include "sim/exec/chip/chip_executor.h"

#include <algorithm>
#include <utility>

namespace robosim::exec {

ChipExecutor::ChipExecutor(const BoardSpec& spec, std::unique_ptr<ChipFirmware> firmware)
    : board_(spec), firmware_(std::move(firmware)) {
  std::copy(firmware_->eeprom().begin(), firmware_->eeprom().end(), board_.memory().begin());
}

void ChipExecutor::power_on(SimTime t) {
  power_off(t);
  state_.ram.clear();
  make_chip(t);
}

void ChipExecutor::power_recovered(SimTime t) {
  power_off(t);
  const std::vector<std::uint8_t> ram = std::move(state_.ram);
  power_on(t);
  chip_->was_browned_out(ram);
}

void ChipExecutor::make_chip(SimTime t) {
  chip_ = firmware_->power_on(clocked_, clocked_.begin_tick(t));
  if (state_.clock_start > 0) chip_->set_clock(state_.clock_start);
  if (tx_provenance_) {
    tx_provenance_->begin([this](const SourceLine& before) { return chip_->printing(before); });
    chip_->trace_bytes(*tx_provenance_);
  }
}

void ChipExecutor::power_off(SimTime t) {
  state_.before = resources();
  state_.resets = watchdog_resets();
  state_.detected = detected();
  if (chip_) state_.ram = chip_->ram();
  chip_.reset();
  state_.crash.reset();
  board_.reset(t);
  state_.reached = t;
}

std::vector<Detected> ChipExecutor::detected() const {
  std::vector<Detected> all = state_.detected;
  if (!chip_) return all;
  for (Detected& seen : chip_->detected()) {
    const auto known = std::find_if(all.begin(), all.end(), [&](const Detected& earlier) {
      return earlier.detector == seen.detector && earlier.where.file == seen.where.file &&
             earlier.where.line == seen.where.line;
    });
    if (known == all.end()) {
      all.push_back(std::move(seen));
    } else {
      known->times += seen.times;
    }
  }
  return all;
}

std::any ChipExecutor::save() const {
  Saved saved{state_, board_.save(), clocked_.save(), {}, firmware_->save(), {}};
  if (chip_) saved.chip = chip_->save();
  if (tx_provenance_) saved.written = tx_provenance_->save();
  return saved;
}

void ChipExecutor::restore(const std::any& from) {
  const auto& saved = std::any_cast<const Saved&>(from);
  firmware_->restore(saved.firmware);
  if (!saved.chip.has_value()) chip_.reset();
  if (saved.chip.has_value() && !chip_) make_chip(0);
  if (chip_) chip_->restore(saved.chip);
  if (tx_provenance_ && saved.written) tx_provenance_->restore(*saved.written);
  board_.restore(saved.board);
  clocked_.restore(saved.clocked);
  state_ = saved.own;
}

void ChipExecutor::run_until(SimTime t) {
  if (!chip_ || state_.crash) return;
  chip_->run_until(clocked_.begin_tick(t));
  state_.reached = t;
  if (chip_->has_crashed()) state_.crash = chip_->crash();
  board_.forget_edges(t);
}

SimTime ChipExecutor::last_call() const {
  return !chip_ || chip_->is_asleep() ? state_.reached : clocked_.to_world(chip_->last_io());
}

bool ChipExecutor::hangs() {
  if (!chip_ || state_.crash) return false;
  const SimTime since = last_call();
  if (!state_.silence.lasts_since(since)) state_.hangs = false;
  if (state_.silence.is_time(since, state_.reached)) state_.hangs = chip_->hangs();
  return state_.hangs;
}

std::optional<Resources> ChipExecutor::resources() const {
  if (!firmware_->fits_chip()) return std::nullopt;
  if (!chip_) return state_.before;
  Resources r = chip_->resources();
  if (state_.before) {
    r.stack_bytes_max = std::max(r.stack_bytes_max, state_.before->stack_bytes_max);
    r.free_bytes_min = std::min(r.free_bytes_min, state_.before->free_bytes_min);
    r.loop_us_max = std::max(r.loop_us_max, state_.before->loop_us_max);
  }
  return r;
}

void ChipExecutor::set_clock_start(SimTime start) {
  const std::string why = firmware_->why_clock_stays();
  if (!why.empty()) throw InputError({firmware_->file()}, "the image has no clock to set (" + why + ")");
  state_.clock_start = start;
}

Activity ChipExecutor::activity() {
  Activity activity;
  if (chip_) activity = chip_->activity();
  activity.last_call = chip_ ? clocked_.to_world(chip_->last_io()) : state_.reached;
  if (state_.crash) activity.where = state_.crash->where;
  return activity;
}

}  // namespace robosim::exec
