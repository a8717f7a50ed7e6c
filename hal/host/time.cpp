// Implements functions for time and pulses (wiring.c and wiring_pulse.c of the Arduino AVR core).
#include <Arduino.h>

#include "hal/board/board_spec.h"
#include "hal/host/api.h"
#include "hal/host/ports.h"
#include "hal/host/registers.h"
#include "hal/host/timers.h"

namespace host = robosim::host;
namespace cost = robosim::host::cost;
using robosim::kNoPin;
using robosim::SimTime;

namespace {

constexpr unsigned long kCyclesPerMicro = host::kClockHz / 1000000;
constexpr unsigned long kMicrosPerTick = 64 / kCyclesPerMicro;
constexpr unsigned long kCyclesPerLoop = 16;  // cycles of pulseIn's loop, as assumed by the core
// The shortest duration of a delayMicroseconds() call.
constexpr unsigned int kShortestDelay_us = host::kClockHz < 16000000 ? 2 : 1;
bool own_yield = true;  // false once the core's yield() has run (the sketch defines none)

unsigned long read_micros() {
  host::spend(cost::kMicros);
  host::timer0.sync();
  const uint16_t count = host::timer0.count();
  uint64_t overflows = host::timer0_count.overflows;
  if (host::timer0.pending() & host::Timer::overflow && count < 255) ++overflows;
  return static_cast<unsigned long>((overflows << 8) + count) * kMicrosPerTick;
}

/// Returns whether micros() continues to advance. micros() stops while interrupts are off.
bool micros_goes_on() {
  return host::interrupts_enabled() && host::timer0.enabled() & host::Timer::overflow &&
         host::timer0.counts_bytes();
}

}  // namespace

extern "C" {

__attribute__((weak)) void yield() { own_yield = false; }

unsigned long millis() {
  host::note_question("millis", kNoPin, 0);
  host::note_clock();
  host::spend_asking(cost::kMillis);
  return static_cast<unsigned long>(host::timer0_count.millis);
}

unsigned long micros() {
  host::note_call("micros", kNoPin, 0);
  return read_micros();
}

void delay(unsigned long ms) {
  host::note_call("delay", kNoPin, 1, static_cast<int32_t>(ms));
  ms = static_cast<uint32_t>(ms);  // 32 bits, as on a chip: delay(-1) takes 49 days
  if (ms >> 31)
    host::executor->acted({robosim::FirmwareAction::Kind::delay, {static_cast<int64_t>(ms), 0, 0}});
  host::be_late_if_due();
  unsigned long start = read_micros() - static_cast<unsigned long>(host::sooner / robosim::kMicrosecond);
  host::sooner = 0;
  if (ms > 0) yield();
  if (!own_yield && micros_goes_on()) {
    const unsigned long elapsed = read_micros() - start;
    const uint64_t us = uint64_t{ms} * 1000;
    if (elapsed < us) {
      const auto ticks = static_cast<int64_t>((us - elapsed) / kMicrosPerTick);
      host::wait_until(host::timer0.ticks_from_now(ticks));
    }
    host::spend(cost::kDelayEnd);
    return;
  }
  const bool outer = host::state.waiting;
  host::state.waiting = !host::in_handler();
  while (ms > 0) {
    yield();
    while (ms > 0 && read_micros() - start >= 1000) {
      --ms;
      start += 1000;
    }
    host::spend(cost::kDelayPoll);
  }
  host::state.waiting = outer;
}

void delayMicroseconds(unsigned int us) {
  host::note_call("delayMicroseconds", kNoPin, 1, static_cast<int32_t>(us));
  // The AVR core counts loops of four cycles in 16 bits: at 16 MHz, the count overflows above 16383 us.
  constexpr unsigned kTurns = kCyclesPerMicro / 4;
  if (strcmp(host::board_spec->chip->target, "avr") == 0) us = (us * kTurns & 0xFFFF) / kTurns;
  host::work((us < kShortestDelay_us ? kShortestDelay_us : us) * robosim::kMicrosecond);
}

unsigned long pulseIn(uint8_t pin, uint8_t value, unsigned long timeout) {
  host::note_call("pulseIn", pin, 2, pin, value);
  if (!host::is_digital(pin)) return 0;
  const bool level = value != LOW;
  unsigned long loops = timeout * kCyclesPerMicro / kCyclesPerLoop;
  const auto poll_while = [&](bool same, int cost_of_turn) {
    while ((host::read_pin(pin) == level) == same) {
      if (loops == 0) return false;
      --loops;
      host::spend(cost_of_turn);
    }
    return true;
  };
  const bool outer = host::state.waiting;
  host::state.waiting = !host::in_handler();
  unsigned long width = 0;
  if (poll_while(true, cost::kPulseWait) && poll_while(false, cost::kPulseWait)) {
    const unsigned long before = loops;
    if (poll_while(true, cost::kPulseLoop)) width = (before - loops + 1) * kCyclesPerLoop / kCyclesPerMicro;
  }
  host::state.waiting = outer;
  return width;
}

unsigned long pulseInLong(uint8_t pin, uint8_t value, unsigned long timeout) {
  host::note_call("pulseInLong", pin, 2, pin, value);
  if (!host::is_digital(pin)) return 0;
  const bool level = value != LOW;
  const bool outer = host::state.waiting;
  host::state.waiting = !host::in_handler();
  const unsigned long begin = read_micros();
  const auto poll_while = [&](bool same) {
    while ((host::read_pin(pin) == level) == same)
      if (read_micros() - begin > timeout) return false;
    return true;
  };
  unsigned long width = 0;
  if (poll_while(true) && poll_while(false)) {
    const unsigned long start = read_micros();
    if (poll_while(true)) width = read_micros() - start;
  }
  host::state.waiting = outer;
  return width;
}

void robosim_spend_cycles(uint64_t count) { host::work(host::cycles(static_cast<int64_t>(count))); }

}  // extern "C"
