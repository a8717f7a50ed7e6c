#include "hal/host/watchdog.h"

#include "hal/host/clock.h"

namespace robosim {
namespace host {

Watchdog watchdog;

namespace {

constexpr SimTime kShortest = 16 * kMillisecond;
// The time for which WDCE stays set. On the chip, this is 4 cycles, but on the host two consecutive
// statements take longer. 64 cycles are enough for the next statement.
constexpr int kWindowCycles = 64;

}  // namespace

SimTime Watchdog::period() const { return kShortest << avr::watchdog_power(control_); }

void Watchdog::schedule() {
  const bool runs = control_ & (kWde | kWdie);
  due_ = runs ? watchdog_.next(state.now, period()) : kNever;
  refresh_deadline();
}

void Watchdog::set_control(uint8_t value) {
  watchdog_.write(control_, value, false, state.now, cycles(kWindowCycles));
  schedule();
}

void Watchdog::restart() {
  watchdog_.origin = state.now;
  schedule();
}

void Watchdog::sync_due() {
  while (due_ <= state.now) {
    if (watchdog_.times_out(control_)) executor->bite();
    due_ += period();
  }
}

}  // namespace host
}  // namespace robosim
