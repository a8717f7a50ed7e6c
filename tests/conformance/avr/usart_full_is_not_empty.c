// While a byte waits in the buffer, UDRE is 0 and its interrupt is not requested.
// Source: DS40002061B, 20.6.3
// Expect: 00 01
#include "report.h"

static volatile uint8_t served;
ISR(USART_UDRE_vect) {
  ++served;
  UCSR0B = _BV(TXEN0);
}

int main(void) {
  sei();
  UCSR0B = _BV(TXEN0);
  UDR0 = 1;
  UDR0 = 2;
  UCSR0B = _BV(TXEN0) | _BV(UDRIE0);
  __builtin_avr_delay_cycles(100);
  report(served);
  __builtin_avr_delay_cycles(100);
  report(served);
  end_program();
}
