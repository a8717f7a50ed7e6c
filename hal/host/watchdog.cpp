#include "hal/host/watchdog.h"

#include "hal/host/clock.h"

namespace robosim {
namespace host {

Watchdog watchdog;

namespace {

// Bits of WDTCSR (DS40002061B, 11.9.2).
constexpr uint8_t kWdif = 0x80, kWdie = 0x40, kWdp3 = 0x20, kWdce = 0x10, kWde = 0x08, kWdp = 0x07;
constexpr SimTime kShortest = 16 * kMillisecond;
constexpr int kLongestWdp = 9;
// The time for which WDCE stays set. On the chip, this is 4 cycles, but on the host two consecutive
// statements take longer. 64 cycles are enough for the next statement.
constexpr int kWindowCycles = 64;

}  // namespace

uint8_t Watchdog::control() const {
  return static_cast<uint8_t>(control_ | (state.now <= unlocked_until_ ? kWdce : 0));
}

SimTime Watchdog::period() const {
  const int power = (control_ & kWdp) | (control_ & kWdp3 ? 8 : 0);
  return kShortest << (power < kLongestWdp ? power : kLongestWdp);
}

void Watchdog::schedule() {
  const SimTime rounds = (state.now - origin_) / period() + 1;
  due_ = control_ & (kWde | kWdie) ? origin_ + rounds * period() : kNever;
  refresh_deadline();
}

void Watchdog::set_control(uint8_t value) {
  constexpr uint8_t kGuarded = kWde | kWdp3 | kWdp;
  const uint8_t before = control_;
  const bool unlocked = state.now <= unlocked_until_;
  const int guarded = unlocked ? value & kGuarded : (before & kGuarded) | (value & kWde);
  control_ = static_cast<uint8_t>((before & kWdif & ~value) | (value & kWdie) | guarded);
  unlocked_until_ = value & kWdce && value & kWde ? state.now + cycles(kWindowCycles) : -1;
  if (!(before & (kWde | kWdie))) origin_ = state.now;
  schedule();
}

void Watchdog::restart() {
  origin_ = state.now;
  schedule();
}

void Watchdog::sync_due() {
  while (due_ <= state.now) {
    const bool answered = control_ & kWdie && !(control_ & kWdif);
    if (control_ & kWde && !answered) executor->bite();
    control_ |= kWdif;
    due_ += period();
  }
}

void Watchdog::acknowledge() { control_ &= static_cast<uint8_t>(~(control_ & kWde ? kWdif | kWdie : kWdif)); }

bool Watchdog::may_bite() const { return control_ & kWde; }
bool Watchdog::may_interrupt() const { return control_ & kWdie; }

}  // namespace host
}  // namespace robosim
