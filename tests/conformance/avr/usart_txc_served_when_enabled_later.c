// If TXC is set before TXCIE, setting TXCIE requests the interrupt; entering the vector clears TXC.
// Source: DS40002061B, 20.6.3
// Expect: 60 01 20
#include "report.h"

static volatile uint8_t served;
ISR(USART_TX_vect) { ++served; }

int main(void) {
  sei();
  UCSR0B = _BV(TXEN0);
  UDR0 = 0;
  __builtin_avr_delay_cycles(200);
  report(UCSR0A);
  UCSR0B = _BV(TXEN0) | _BV(TXCIE0);
  NOPS(4);
  report(served);
  report(UCSR0A);
  end_program();
}
