// In idle mode peripherals keep running: the end of a frame wakes the chip.
// Source: DS40002061B, 10.3
// Expect: 01 02
#include "report.h"

ISR(USART_TX_vect) { report(1); }

int main(void) {
  UCSR0B = _BV(TXEN0) | _BV(TXCIE0);
  SMCR = _BV(SE);
  sei();
  UDR0 = 0;
  sleep_cpu();
  report(2);
  end_program();
}
