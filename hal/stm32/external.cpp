// Implements attachInterrupt() for any pin (RM0008 10.2, 9.4.3). Pins with the same bit number share an EXTI
// line. The line serves only the pin that was attached last.
#include <Arduino.h>

#include "hal/stm32/pins.h"

using namespace robosim::stm32;

namespace {

using Handler = void (*)();
Handler volatile handlers[16];

Irq irq_of(uint8_t line) {
  return line < 5 ? static_cast<Irq>(kIrqExti0 + line) : line < 10 ? kIrqExti9_5 : kIrqExti15_10;
}

void serve(uint8_t first, uint8_t last) {
  const uint32_t pending = load(kExtiPr) & load(kExtiImr);
  for (uint8_t line = first; line <= last; ++line) {
    if (!(pending >> line & 1u)) continue;
    at(kExtiPr) = 1u << line;  // writing 1 clears the bit (10.3.6)
    if (handlers[line]) handlers[line]();
  }
}

}  // namespace

extern "C" {

void attachInterrupt(uint8_t number, void (*handler)(void), int mode) {
  const PinMap* pin = pin_at(number);
  if (!pin) return;
  const uint32_t bit = 1u << pin->bit;
  const uint32_t shift = 4u * (pin->bit % 4u);
  const Quiet quiet;
  handlers[pin->bit] = handler;
  at(kAfioExticr1 + 4u * (pin->bit / 4u)).set(15u << shift, static_cast<uint32_t>(pin->port) << shift);
  at(kExtiRtsr).set(bit, mode == RISING || mode == CHANGE ? bit : 0);
  at(kExtiFtsr).set(bit, mode == FALLING || mode == CHANGE ? bit : 0);
  at(kExtiPr) = bit;
  at(kExtiImr) |= bit;
  enable_irq(irq_of(pin->bit));
}

void detachInterrupt(uint8_t number) {
  const PinMap* pin = pin_at(number);
  if (!pin) return;
  const Quiet quiet;
  at(kExtiImr) &= ~(1u << pin->bit);
  handlers[pin->bit] = nullptr;
}

void EXTI0_IRQHandler() { serve(0, 0); }
void EXTI1_IRQHandler() { serve(1, 1); }
void EXTI2_IRQHandler() { serve(2, 2); }
void EXTI3_IRQHandler() { serve(3, 3); }
void EXTI4_IRQHandler() { serve(4, 4); }
void EXTI9_5_IRQHandler() { serve(5, 9); }
void EXTI15_10_IRQHandler() { serve(10, 15); }

}  // extern "C"
