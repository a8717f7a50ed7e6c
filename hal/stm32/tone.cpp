// Implements tone(): timer 1 causes an interrupt at each edge. During a tone, analogWrite has no effect on
// the pins 0, 1, 3 and 28.
#include <Arduino.h>

#include "hal/stm32/clock.h"
#include "hal/stm32/pins.h"

using namespace robosim::stm32;

namespace {

const PinMap* volatile sounding;
volatile uint32_t edges_left;  ///< number of edges until the end of the tone, if `ends`
volatile bool ends;

void stop() {
  at(kTim1 + kTimDier) = 0;
  at(kTim1 + kTimCr1) = 0;
  at(kTim1 + kTimSr) = 0;
  if (sounding) write_pin(*sounding, false);
  sounding = nullptr;
}

}  // namespace

void tone(uint8_t number, unsigned int frequency, unsigned long duration) {
  const PinMap* pin = pin_at(number);
  if (!pin || frequency == 0) return;
  if (sounding && sounding != pin) return;  // only one tone at a time, as on an Uno
  at(kRccApb2Enr) |= kTim1En;
  stop();
  if (configuration(*pin) != kPushPull) pinMode(number, OUTPUT);
  uint32_t cycles = F_CPU / (2 * frequency);
  if (cycles == 0) cycles = 1;
  const uint32_t prescaler = cycles / 65536 + 1;
  at(kTim1 + kTimCcer) = 0;
  at(kTim1 + kTimPsc) = prescaler - 1;
  at(kTim1 + kTimArr) = cycles / prescaler - 1;
  at(kTim1 + kTimEgr) = kUg;  // loads the prescaler (RM0008 14.3.1)
  at(kTim1 + kTimSr) = 0;
  sounding = pin;
  ends = duration > 0;
  edges_left = static_cast<uint32_t>(2ull * frequency * duration / 1000);
  at(kTim1 + kTimDier) = kUie;
  enable_irq(kIrqTim1Update);
  at(kTim1 + kTimCr1) = kUrs | kCen;
}

void noTone(uint8_t number) {
  if (sounding && sounding == pin_at(number)) stop();
  digitalWrite(number, LOW);
}

extern "C" void TIM1_UP_IRQHandler() {
  at(kTim1 + kTimSr) = 0;
  if (!sounding) return;
  if (ends && edges_left == 0) return stop();
  if (ends) edges_left = edges_left - 1;
  toggle_pin(*sounding);
}
