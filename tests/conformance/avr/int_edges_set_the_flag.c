// INTF0 is set by the edges that ISC0 selects (any, falling or rising), even by the chip's own output, and
// without EIMSK.
// Source: DS40002061B, 13.2.1, 13.2.3
// Expect: 01 01 00 01 01 00
#include "report.h"

static void edges(uint8_t sense) {
  EICRA = sense;
  EIFR = _BV(INTF0);
  PORTD = _BV(PORTD2);
  NOPS(4);
  report(EIFR);
  EIFR = _BV(INTF0);
  PORTD = 0;
  NOPS(4);
  report(EIFR);
}

int main(void) {
  DDRD = _BV(DDD2);
  edges(_BV(ISC00));
  edges(_BV(ISC01));
  edges(_BV(ISC01) | _BV(ISC00));
  end_program();
}
