#include "hal/host/tone.h"

#include <Arduino.h>

#include "hal/host/api.h"
#include "hal/host/ports.h"
#include "hal/host/timers.h"
#include "hal/host/waves.h"

namespace host = robosim::host;
namespace cost = robosim::host::cost;
using robosim::kNever;
using robosim::kNoPin;
using robosim::Pin;
using robosim::SimTime;

namespace {

Pin sounding = kNoPin;
// The pin toggles every `half_period` cycles from the time `began` on, when its level was `level_then`.
int64_t half_period = 1;
SimTime began = 0;
bool level_then = false;

constexpr int64_t kPrescalers[7] = {1, 8, 32, 64, 128, 256, 1024};

void stop() {
  // Restores 8-bit phase correct PWM, as set by init(). The core does so in disableTimer(2).
  host::timer2.set_control_a(1);
  host::timer2.set_control_b(4);
  host::timer2.set_compare(0, 0);
  const Pin pin = sounding;
  sounding = kNoPin;
  host::tone_end = kNever;
  host::ports[host::port_of(pin)].output &= static_cast<uint8_t>(~host::mask_of(pin));
  host::set_tone(pin, 0);
}

}  // namespace

namespace robosim {
namespace host {

SimTime tone_end = kNever;

bool tone_level(SimTime at) { return level_then != (kCycles.whole(at - began, half_period) % 2 != 0); }

SimTime next_tone_edge(SimTime after) {
  return began + kCycles.at_least((kCycles.whole(after - began, half_period) + 1) * half_period);
}

bool sounds() { return sounding != kNoPin; }

void end_tone() { stop(); }

}  // namespace host
}  // namespace robosim

void tone(uint8_t pin, unsigned int frequency, unsigned long duration) {
  host::note_call("tone", pin, 2, pin, static_cast<int32_t>(frequency));
  host::spend(cost::kTone);
  if (!host::is_digital(pin) || frequency == 0) return;
  if (sounding != kNoPin && sounding != pin) return;  // the core plays one tone at a time
  int clock = 0;
  int64_t top = 0;
  for (;; ++clock) {
    top = host::kClockHz / frequency / 2 / kPrescalers[clock] - 1;
    if (top <= 255 || clock == 6) break;
  }
  top = (top < 0 ? 0 : top) & 0xFF;
  host::sync_waves();
  const uint8_t mask = host::mask_of(pin);
  level_then = sounding == pin ? host::tone_level(host::state.now)
                               : (host::ports[host::port_of(pin)].output & mask) != 0;
  began = host::state.now;
  half_period = kPrescalers[clock] * (top + 1);
  sounding = pin;
  host::timer2.set_control_a(2);  // clear on match, pins 3 and 11 disconnected
  host::timer2.set_control_b(static_cast<uint8_t>(clock + 1));
  host::timer2.set_compare(0, static_cast<uint16_t>(top));
  host::ports[host::port_of(pin)].direction |= mask;
  const int64_t period = 2 * half_period;
  host::set_tone(pin, static_cast<uint32_t>((host::kClockHz + period / 2) / period));
  const uint64_t toggles = 2 * static_cast<uint64_t>(frequency) * duration / 1000;
  host::tone_end =
      duration > 0 ? host::state.now + host::cycles(static_cast<int64_t>(toggles) * period / 2) : kNever;
  host::refresh_waves();
  host::refresh_deadline();
}

void noTone(uint8_t pin) {
  host::note_call("noTone", pin, 1, pin);
  host::spend(cost::kNoTone);
  if (sounding == pin) stop();
  host::refresh_deadline();
}
