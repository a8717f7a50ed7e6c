#include "sim/avr/power.h"

#include "hal/board/avr_registers.h"

namespace robosim::avr {
namespace {

constexpr std::uint8_t kSleepEnable = 0x01, kModeMask = 0x0E, kIdle = 0x00, kNoiseReduction = 0x02;
constexpr std::uint8_t kClockChangeEnable = 0x80, kDivisorMask = 0x0F, kLargestDivisor = 8;
constexpr std::uint8_t kResetFlags = 0x0F;
constexpr Cycle kDivisorWindow = 4;
constexpr Cycle kWakeCycles = 4, kStartUpCycles = 16384;

}  // namespace

Power::Power(Core& core) : core_(core) {
  core.cpu.on_write<&Power::write_divisor>(reg::kClkpr, this);
  core.cpu.on_write<&Power::write_reset_flags>(reg::kMcusr, this);
  core.keep(state_);
}

void Power::supply(Peripheral& peripheral, Clock clock, Address reduction, int bit) {
  supplied_.push_back({&peripheral, clock, reduction, static_cast<std::uint8_t>(bit < 0 ? 0 : 1 << bit)});
  if (bit >= 0) core_.cpu.on_write<&Power::write_reduction>(reduction, this);
}

void Power::reset(Cycle at) {
  if (state_.asleep) state_.slept += at - state_.slept_from;
  const Cycle slept = state_.slept;
  state_ = {};
  state_.slept = slept;
}

void Power::write_reduction(Address address, std::uint8_t value) {
  core_.at(address) = value;
  update(core_.now());
}

// 9.12.2: CLKPCE alone first, the divisor within four cycles.
void Power::write_divisor(Address address, std::uint8_t value) {
  const Cycle now = core_.now();
  if (value == kClockChangeEnable) {
    state_.divisor_unlocked_until = now + kDivisorWindow;
    core_.at(address) |= kClockChangeEnable;
    return;
  }
  if (value & kClockChangeEnable || now > state_.divisor_unlocked_until) return;
  state_.divisor_unlocked_until = 0;
  const auto divisor = static_cast<std::uint8_t>(value & kDivisorMask);
  if (divisor > kLargestDivisor) return;
  core_.at(address) = divisor;
  core_.outside.clock_divided(1 << divisor, now);
}

// 11.9.1: a flag is cleared by writing 0 to it.
void Power::write_reset_flags(Address address, std::uint8_t value) {
  core_.at(address) &= value & kResetFlags;
}

void Power::update(Cycle at) {
  for (std::size_t i = 0; i < supplied_.size(); ++i) {
    const Supplied& supplied = supplied_[i];
    const bool clock = supplied.clock == Clock::io ? state_.io_runs : state_.adc_runs;
    const bool runs = clock && !(supplied.mask && core_.at(supplied.reduction) & supplied.mask);
    const std::uint64_t bit = std::uint64_t{1} << i;
    if (runs == !(state_.stopped & bit)) continue;
    state_.stopped ^= bit;
    supplied.peripheral->clock_runs(runs, at);
  }
}

bool Power::sleep(Cycle at) {
  const std::uint8_t control = core_.at(reg::kSmcr);
  if (!(control & kSleepEnable)) return false;
  const int mode = control & kModeMask;
  state_.asleep = true;
  state_.slept_from = at;
  for (const Supplied& supplied : supplied_) supplied.peripheral->falls_asleep(mode == kNoiseReduction, at);
  state_.io_runs = mode == kIdle;
  state_.adc_runs = mode == kIdle || mode == kNoiseReduction;
  update(at);
  return true;
}

void Power::wake(Cycle at) {
  const Cycle start_up = state_.adc_runs ? 0 : kStartUpCycles;
  core_.cpu.skip_to(at + start_up + kWakeCycles);
  state_.asleep = false;
  state_.slept += core_.now() - state_.slept_from;
  state_.io_runs = state_.adc_runs = true;
  update(at + start_up);
}

}  // namespace robosim::avr
