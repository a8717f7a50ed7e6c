// Implements the differences between an ATtiny85's timer 1 and other timers (data sheet 2586Q, chapter 12).
//
//   TCCR1    CTC1, PWM1A, COM1A; CS13 to CS10: the clock is divided by 2^(CS - 1)
//   GTCCR    PWM1B, COM1B, FOC1B, FOC1A; for PSR1 and timer 0's bits, see timer_prescaler.h
//   OCR1C    TOP with PWM, and with CTC1; 0xFF after a reset
//   PLLCSR   PLLE: starts the PLL, which locks (PLOCK) 100 us later; PCKE: the PLL (64 MHz) clocks the timer
//
// TCCR1 and GTCCR are stored in the layout of an ATmega's TCCRnA and TCCRnB. PWM for one channel is treated
// as PWM for both channels. The ratio of 64 MHz to the processor's clock is rounded to a power of two: 4, 8
// ... A timer that would be faster than the processor counts once per cycle.
//
// Not modelled: the synchronisation of writes (one and a half cycles, figure 12-2), the inverted outputs and
// their dead times (chapter 14), and ATtiny15 mode.
#include <algorithm>
#include <bit>

#include "sim/mcu/avr/timer.h"

namespace robosim::avr {
namespace {

constexpr std::uint8_t kCtc = 0x80, kPwm = 0x40, kConnection = 0x30, kClock = 0x0F;
constexpr std::uint8_t kForce1A = 0x04, kForce1B = 0x08;
constexpr std::uint8_t kPllEnable = 0x02, kPllLocked = 0x01, kPllClock = 0x04;
constexpr std::int64_t kLockTime_ns = 100'000, kPll_hz = 64'000'000;

}  // namespace

void Timer::hook_pll_registers() {
  Cpu& cpu = core_.cpu;
  cpu.on_write<&Timer::write_pll_control>(static_cast<Address>(spec_.control), this);
  cpu.also_on_write<&Timer::write_pll_general>(core_.chip.at.timers, this);
  cpu.on_write<&Timer::write_top>(spec_.top, this);
  cpu.on_read<&Timer::read_plain>(spec_.top, this);
  cpu.on_write<&Timer::write_pll>(core_.chip.at.pll, this);
  cpu.on_read<&Timer::read_pll>(core_.chip.at.pll, this);
}

void Timer::take_pll_control() {
  const std::uint8_t control = core_.at(static_cast<Address>(spec_.control)),
                     general = core_.at(core_.chip.at.timers);
  const bool pwm = (control | general) & kPwm;
  unsigned a = control & kConnection, b = general & kConnection;
  // Treats COM = 1 like COM = 2, without the inverted output that COM = 1 adds.
  if (pwm && a == 0x10) a = 0x20;
  if (pwm && b == 0x10) b = 0x20;
  const unsigned mode = pwm ? 3 : control & kCtc ? 2 : 0;
  state_.control_a = static_cast<std::uint8_t>(a << 2 | b | mode);
  state_.control_b = control & kClock;
  set_mode();
}

void Timer::write_pll_control(Address address, std::uint8_t value) {
  count_to(core_.now());
  if (!state_.runs) return;
  core_.at(address) = value;
  take_pll_control();
  settle();
}

void Timer::write_pll_general(Address, std::uint8_t value) {
  count_to(core_.now());
  if (!state_.runs) return;
  take_pll_control();
  force(static_cast<std::uint8_t>((value & kForce1A ? kFoca : 0) | (value & kForce1B ? kFocb : 0)));
  settle();
}

void Timer::write_top(Address address, std::uint8_t value) {
  count_to(core_.now());
  if (!state_.runs) return;
  core_.at(address) = value;
  state_.counter.set_capture(value);
  state_.drives_stale = true;
  settle();
}

void Timer::write_pll(Address address, std::uint8_t value) {
  count_to(core_.now());
  const bool was_on = core_.at(address) & kPllEnable;
  core_.at(address) = static_cast<std::uint8_t>(value & ~kPllLocked);
  if (!(value & kPllEnable)) {
    state_.pll_locked_at = kNoCycle;
  } else if (!was_on) {
    state_.pll_locked_at = core_.now() + core_.cycles(kLockTime_ns);
  }
  set_mode();
  settle();
}

std::uint8_t Timer::read_pll(Address address) {
  return static_cast<std::uint8_t>(core_.at(address) |
                                   (core_.now() >= state_.pll_locked_at ? kPllLocked : 0));
}

// Returns the ratio of the PLL's clock to the processor's clock, as an exponent of two.
int Timer::pll_shift() const {
  if (!spec_.top || !(core_.cpu.data[core_.chip.at.pll] & kPllClock)) return 0;
  return std::countr_zero(std::bit_ceil(static_cast<std::uint64_t>(kPll_hz / core_.clock_hz)));
}

}  // namespace robosim::avr
