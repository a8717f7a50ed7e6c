// The interrupt `data register empty` repeats until UDR is written or UDRIE is cleared.
// Source: DS40002061B, 20.6.3
// Expect: 03
#include "report.h"

static volatile uint8_t served;
ISR(USART_UDRE_vect) {
  if (++served == 3) UCSR0B = _BV(TXEN0);
}

int main(void) {
  UCSR0B = _BV(TXEN0) | _BV(UDRIE0);
  sei();
  NOPS(10);
  report(served);
  end_program();
}
