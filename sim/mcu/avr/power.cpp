#include "sim/mcu/avr/power.h"

#include <bit>

#include "hal/board/avr_registers.h"

namespace robosim::avr {
namespace {

constexpr int kIdle = 0, kNoiseReduction = 1, kStandby = 6, kExtendedStandby = 7;  // values of SM
constexpr std::uint8_t kDivisorMask = 0x0F, kLargestDivisor = 8;
constexpr Cycle kDivisorWindow = 4;
constexpr Cycle kWakeCycles = 4, kStandbyStartUp = 6;

constexpr Cycle start_up_of(int mode, Cycle of_oscillator) {
  switch (mode) {
    case kIdle:
    case kNoiseReduction:
      return 0;
    case kStandby:
    case kExtendedStandby:
      return kStandbyStartUp;
    default:
      return of_oscillator;
  }
}

}  // namespace

Power::Power(Core& core) : core_(core) {
  core.cpu.on_read<&Power::read_divisor>(core.chip.at.clock_divisor, this);
  core.cpu.on_write<&Power::write_divisor>(core.chip.at.clock_divisor, this);
  core.cpu.on_write<&Power::write_reset_flags>(reg::kMcusr, this);
  core.keep(state_);
}

void Power::supply(Peripheral& peripheral, Clock clock, Address reduction, int bit) {
  supplied_.push_back({&peripheral, clock, reduction, static_cast<std::uint8_t>(bit < 0 ? 0 : 1 << bit)});
  if (clock == Clock::adc) on_adc_clock_.push_back(&peripheral);
  if (bit >= 0) core_.cpu.on_write<&Power::write_reduction>(reduction, this);
}

void Power::reset(Cycle at) {
  if (state_.asleep) state_.slept += at - state_.slept_from;
  const Cycle slept = state_.slept;
  state_ = {};
  state_.slept = slept;
  divide_clock(1, at);
}

void Power::write_reduction(Address address, std::uint8_t value) {
  core_.at(address) = value;
  update(core_.now());
}

std::uint8_t Power::read_divisor(Address address) {
  const bool unlocked = core_.now() <= state_.divisor_unlocked_until;
  return static_cast<std::uint8_t>(core_.at(address) | (unlocked ? kClkpce : 0));
}

// Changes the divisor (9.12.2). Firmware first writes CLKPCE alone, then the divisor within four cycles.
// Writing CLKPCE again does not extend this window.
void Power::write_divisor(Address address, std::uint8_t value) {
  const Cycle now = core_.now();
  const bool unlocked = now <= state_.divisor_unlocked_until;
  if (value == kClkpce && !unlocked) state_.divisor_unlocked_until = now + kDivisorWindow;
  if (value & kClkpce || !unlocked) return;
  state_.divisor_unlocked_until = 0;
  const auto divisor = static_cast<std::uint8_t>(value & kDivisorMask);
  if (divisor > kLargestDivisor) return;
  core_.at(address) = divisor;
  divide_clock(1 << divisor, now);
}

void Power::divide_clock(int divisor, Cycle at) {
  const std::int64_t before = core_.clock_hz;
  core_.divide_clock(divisor);
  if (core_.clock_hz != before) core_.environment.clock_divided(divisor, at);
}

// Clears each flag to which 0 is written (11.9.1).
void Power::write_reset_flags(Address address, std::uint8_t value) {
  core_.at(address) &= value & (kWdrf | kBorf | kExtrf | kPorf);
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
  const AvrRegisters& at_chip = core_.chip.at;
  const std::uint8_t control = core_.at(at_chip.sleep);
  if (!(control & at_chip.sleep_enable)) return false;
  const int mode = (control & at_chip.sleep_modes) >> std::countr_zero(unsigned{at_chip.sleep_modes});
  const bool adc_runs = mode == kIdle || mode == kNoiseReduction;
  state_.asleep = true;
  state_.slept_from = at;
  for (Peripheral* peripheral : on_adc_clock_) peripheral->falls_asleep(adc_runs, at);
  state_.start_up = start_up_of(mode, core_.chip.start_up_cycles);
  let_run(mode == kIdle, adc_runs, at);
  return true;
}

void Power::wake(Cycle at) {
  core_.cpu.skip_to(at + state_.start_up + kWakeCycles);
  state_.asleep = false;
  state_.slept += core_.now() - state_.slept_from;
  let_run(true, true, at + state_.start_up);
}

void Power::let_run(bool io, bool adc, Cycle at) {
  if (io == state_.io_runs && adc == state_.adc_runs) return;
  state_.io_runs = io;
  state_.adc_runs = adc;
  update(at);
}

}  // namespace robosim::avr
