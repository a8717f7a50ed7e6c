// ACI is set by the edges of ACO that ACIS selects: any, falling or rising; writing 1 clears ACI.
// Source: DS40002061B, 23.3.1
// Expect: 30 10 00 12 33 03
#include "report.h"

// AIN0 is an output, AIN1 an input at low level.
static void edges(uint8_t sense) {
  ACSR = sense | _BV(ACI);
  PORTD = _BV(PORTD6);
  NOPS(4);
  uint8_t high = ACSR;
  ACSR = sense | _BV(ACI);
  PORTD = 0;
  NOPS(4);
  uint8_t low = ACSR;
  if (sense != _BV(ACIS1)) report(high);
  report(low);
}

int main(void) {
  DDRD = _BV(DDD6);
  edges(0);
  ACSR = _BV(ACI);
  report(ACSR);
  edges(_BV(ACIS1));
  edges(_BV(ACIS1) | _BV(ACIS0));
  end_program();
}
