// Implements millis, micros, delay and pulse measurement, by SysTick (PM0056 4.5).
#include <Arduino.h>

#include "hal/stm32/clock.h"
#include "hal/stm32/pins.h"

using namespace robosim::stm32;

namespace {

constexpr uint32_t kCyclesPerMilli = F_CPU / 1000u;
/// The maximum time, in us, that the beginning and the end of a sleep take: about 400 cycles.
constexpr uint32_t kSleepUs = 400u / kCyclesPerMicro + 1u;

/// Waits by SysTick's counter alone, because with interrupts off, micros() stops within a millisecond.
void spin(uint32_t us) {
  uint32_t last = load(kStkVal), cycles = 0;
  while (us > 0) {
    const uint32_t count = load(kStkVal);
    cycles += last >= count ? last - count : last + kCyclesPerMilli - count;
    last = count;
    for (; us > 0 && cycles >= kCyclesPerMicro; cycles -= kCyclesPerMicro) --us;
  }
}

/// Waits while `pin` stays at `level`. Returns false once `timeout` us have passed since `start`.
bool wait_while(const PinMap& pin, bool level, unsigned long start, unsigned long timeout) {
  while (read_pin(pin) == level)
    if (micros() - start >= timeout) return false;
  return true;
}

}  // namespace

extern "C" {

void init() {
  start_pins();
  start_systick();
}

__attribute__((weak)) void yield() {}

unsigned long millis() { return robosim_millis; }

unsigned long micros() {
  const Quiet quiet;
  uint32_t count = load(kStkVal);
  uint32_t ms = robosim_millis;
  // The counter may have reached 0 with its interrupt still pending.
  if (load(kScbIcsr) & kPendStSet) {
    count = load(kStkVal);
    ++ms;
  }
  const uint32_t cycles = count > 0 ? kCyclesPerMilli - count : 0;
  return ms * 1000u + cycles / kCyclesPerMicro;
}

void delay(unsigned long ms) {
  unsigned long start = micros();
  while (ms > 0) {
    yield();
    const unsigned long elapsed = micros() - start;
    if (elapsed >= 1000) {
      --ms;
      start += 1000;
    } else if (ms == 1) {
      sleep_for(1000 - elapsed);
    } else {
      wait_for_interrupt();
    }
  }
}

void delayMicroseconds(unsigned int us) {
  if (!takes_interrupts()) return spin(us);
  const unsigned long start = micros();
  for (unsigned long elapsed = 0; elapsed < us; elapsed = micros() - start) {
    const unsigned long left = us - elapsed;
    if (left > 2 * kSleepUs) sleep_for(left - kSleepUs < 1000 ? left - kSleepUs : 1000);
  }
}

unsigned long pulseIn(uint8_t number, uint8_t state, unsigned long timeout) {
  const PinMap* pin = pin_at(number);
  if (!pin) return 0;
  const bool level = state != LOW;
  const unsigned long start = micros();
  if (!wait_while(*pin, level, start, timeout) || !wait_while(*pin, !level, start, timeout)) return 0;
  const unsigned long begin = micros();
  return wait_while(*pin, level, start, timeout) ? micros() - begin : 0;
}

unsigned long pulseInLong(uint8_t pin, uint8_t state, unsigned long timeout) {
  return pulseIn(pin, state, timeout);
}

}  // extern "C"
