#include "sim/mcu/avr/watchdog.h"

namespace robosim::avr {
namespace {

constexpr Cycle kWdceWindow = 4;
constexpr std::int64_t kShortestCycles = 2048, kWatchdogClock_hz = 128'000;

}  // namespace

Watchdog::Watchdog(Core& core) : core_(core), control_(core.chip.at.watchdog) {
  core.cpu.on_read<&Watchdog::read>(control_, this);
  core.cpu.on_write<&Watchdog::write>(control_, this);
  core.cpu.on_wdr = Cpu::call<&Watchdog::restart>(this);
  core.interrupts.on_entry<&Watchdog::entered>(core.chip.watchdog_vector, this);
  core.on_clock_change<&Watchdog::clock_changed>(this);
  timed_out_ = core.events.add<&Watchdog::timed_out>(this);
  core.keep(state_);
}

bool Watchdog::held() const { return core_.cpu.data[reg::kMcusr] & kWdrf; }

void Watchdog::reset(Cycle at) {
  state_ = {};
  state_.origin = at;
  if (held()) core_.at(control_) = kWde;
  schedule();
}

Cycle Watchdog::period() const {
  const int power = watchdog_power(core_.cpu.data[control_]);
  return static_cast<Cycle>((kShortestCycles << power) * core_.clock_hz / kWatchdogClock_hz);
}

void Watchdog::schedule() {
  const std::uint8_t control = core_.at(control_);
  core_.reset_may_come = control & kWde;
  if (!(control & (kWde | kWdie))) return core_.events.cancel(timed_out_);
  core_.schedule(timed_out_, state_.next(core_.now(), period()));
}

std::uint64_t Watchdog::may_interrupt() const {
  return Interrupts::bit(core_.chip.watchdog_vector, core_.cpu.data[control_] & kWdie);
}

void Watchdog::request() {
  const std::uint8_t control = core_.at(control_);
  core_.request(core_.chip.watchdog_vector, control & kWdif && control & kWdie);
}

std::uint8_t Watchdog::read(Address address) { return state_.read(core_.at(address), core_.now()); }

void Watchdog::write(Address address, std::uint8_t value) {
  state_.write(core_.at(address), value, held(), core_.now(), kWdceWindow);
  schedule();
  request();
}

void Watchdog::restart() {
  state_.origin = core_.now();
  schedule();
}

void Watchdog::timed_out(Cycle at) {
  if (state_.times_out(core_.at(control_))) return core_.reset(core_.reset_self, kWdrf);
  core_.schedule(timed_out_, at + period());
  request();
}

void Watchdog::entered(int) {
  state_.enter(core_.at(control_));
  request();
}

void Watchdog::clock_changed(std::int64_t hz_before) {
  const auto passed = static_cast<std::int64_t>(core_.now() - state_.origin);
  state_.origin = core_.now() - static_cast<Cycle>(passed * core_.clock_hz / hz_before);
  schedule();
}

}  // namespace robosim::avr
