// Entering idle sleep also starts a conversion, even if ADIE is 0.
// Source: DS40002061B, 10.3, 24.6
// Expect: c7 97
// Host: not simulated: conversions that sleep starts
#include "report.h"

ISR(USART_TX_vect) {}

int main(void) {
  ADCSRA = _BV(ADEN) | 7;
  UCSR0B = _BV(TXEN0) | _BV(TXCIE0);
  SMCR = _BV(SE);
  sei();
  UDR0 = 0;
  sleep_cpu();
  report(ADCSRA);
  __builtin_avr_delay_cycles(26 * 128);
  report(ADCSRA);
  end_program();
}
