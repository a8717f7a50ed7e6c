#include "sim/mcu/avr/watchdog.h"

#include <algorithm>

#include "hal/board/avr_registers.h"

namespace robosim::avr {
namespace {

constexpr std::uint8_t kWdif = 0x80, kWdie = 0x40, kWdp3 = 0x20, kWdce = 0x10, kWde = 0x08;
constexpr std::uint8_t kWdpMask = kWdp3 | 0x07;
constexpr std::uint8_t kWdrf = 0x08;  // bit of MCUSR
constexpr Cycle kWdceWindow = 4;
constexpr int kLongestWdp = 9;
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
  const std::uint8_t control = core_.cpu.data[control_];
  const int power = std::min((control & kWdp3 ? 8 : 0) | (control & 7), kLongestWdp);
  return static_cast<Cycle>((kShortestCycles << power) * core_.clock_hz / kWatchdogClock_hz);
}

void Watchdog::schedule() {
  const std::uint8_t control = core_.at(control_);
  core_.reset_may_come = control & kWde;
  if (!(control & (kWde | kWdie))) return core_.events.cancel(timed_out_);
  const Cycle passed = core_.now() - state_.origin;
  core_.schedule(timed_out_, state_.origin + (passed / period() + 1) * period());
}

std::uint64_t Watchdog::may_interrupt() const {
  return Interrupts::bit(core_.chip.watchdog_vector, core_.cpu.data[control_] & kWdie);
}

void Watchdog::request() {
  const std::uint8_t control = core_.at(control_);
  core_.request(core_.chip.watchdog_vector, control & kWdif && control & kWdie);
}

std::uint8_t Watchdog::read(Address address) {
  const bool unlocked = core_.now() <= state_.unlocked_until;
  return static_cast<std::uint8_t>(core_.at(address) | (unlocked ? kWdce : 0));
}

void Watchdog::write(Address address, std::uint8_t value) {
  const Cycle now = core_.now();
  const std::uint8_t before = core_.at(address);
  const bool unlocked = now <= state_.unlocked_until;
  std::uint8_t locked = unlocked ? value & (kWde | kWdpMask) : (before & (kWde | kWdpMask)) | (value & kWde);
  if (held()) locked |= kWde;
  const auto flag = static_cast<std::uint8_t>(before & kWdif & ~value);
  core_.at(address) = static_cast<std::uint8_t>(flag | (value & kWdie) | locked);
  state_.unlocked_until = value & kWdce && value & kWde ? now + kWdceWindow : 0;
  if (!(before & (kWde | kWdie))) state_.origin = now;
  schedule();
  request();
}

void Watchdog::restart() {
  state_.origin = core_.now();
  schedule();
}

void Watchdog::timed_out(Cycle at) {
  std::uint8_t& control = core_.at(control_);
  const bool answered = control & kWdie && !(control & kWdif);
  if (control & kWde && !answered) return core_.reset(core_.reset_self, kWdrf);
  control |= kWdif;
  core_.schedule(timed_out_, at + period());
  request();
}

void Watchdog::entered(int) {
  std::uint8_t& control = core_.at(control_);
  control &= static_cast<std::uint8_t>(~(control & kWde ? kWdif | kWdie : kWdif));
  request();
}

void Watchdog::clock_changed(std::int64_t hz_before) {
  const auto passed = static_cast<std::int64_t>(core_.now() - state_.origin);
  state_.origin = core_.now() - static_cast<Cycle>(passed * core_.clock_hz / hz_before);
  schedule();
}

}  // namespace robosim::avr
