// Implements pinMode, digitalWrite and digitalRead (RM0008 9), shiftOut and shiftIn.
#include <Arduino.h>

#include "hal/stm32/pins.h"

using namespace robosim::stm32;

extern "C" {

void pinMode(uint8_t number, uint8_t mode) {
  const PinMap* pin = pin_at(number);
  if (!pin) return;
  if (mode == INPUT_PULLUP) write_pin(*pin, true);  // selects pull-up (9.1.1)
  configure(*pin, mode == OUTPUT ? kPushPull : mode == INPUT_PULLUP ? kPulled : kFloating);
}

void digitalWrite(uint8_t number, uint8_t level) {
  const PinMap* pin = pin_at(number);
  if (!pin) return;
  write_pin(*pin, level != LOW);
  // digitalWrite ends analogWrite, as on an Uno.
  if (is_alternate(configuration(*pin))) configure(*pin, kPushPull);
}

int digitalRead(uint8_t number) {
  const PinMap* pin = pin_at(number);
  return pin && read_pin(*pin) ? HIGH : LOW;
}

void shiftOut(uint8_t data_pin, uint8_t clock_pin, uint8_t bit_order, uint8_t value) {
  for (uint8_t i = 0; i < 8; ++i) {
    digitalWrite(data_pin, value >> (bit_order == LSBFIRST ? i : 7 - i) & 1);
    digitalWrite(clock_pin, HIGH);
    digitalWrite(clock_pin, LOW);
  }
}

uint8_t shiftIn(uint8_t data_pin, uint8_t clock_pin, uint8_t bit_order) {
  uint8_t value = 0;
  for (uint8_t i = 0; i < 8; ++i) {
    digitalWrite(clock_pin, HIGH);
    value = static_cast<uint8_t>(value | digitalRead(data_pin) << (bit_order == LSBFIRST ? i : 7 - i));
    digitalWrite(clock_pin, LOW);
  }
  return value;
}

}  // extern "C"
