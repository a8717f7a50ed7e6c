// A transfer as master takes 8 bits of 4 cycles each (2 with SPI2X, up to 128 by SPR), and then sets SPIF.
// Source: DS40002061B, 19.5.1, table 19-5
// Expect: 00 80 01 81 00 80
#include "report.h"

#define STATUS_AFTER(cycles)                  \
  ({                                          \
    SPDR = 0x55;                              \
    __builtin_avr_delay_cycles((cycles) - IN_TAKES); \
    uint8_t status = SPSR;                    \
    __builtin_avr_delay_cycles(1100);         \
    (void)SPSR;                               \
    (void)SPDR;                               \
    status;                                   \
  })

int main(void) {
  DDRB = _BV(DDB2) | _BV(DDB3) | _BV(DDB5);
  SPCR = _BV(SPE) | _BV(MSTR);
  report(STATUS_AFTER(31));
  report(STATUS_AFTER(32));
  SPSR = _BV(SPI2X);
  report(STATUS_AFTER(15));
  report(STATUS_AFTER(16));
  SPSR = 0;
  SPCR = _BV(SPE) | _BV(MSTR) | _BV(SPR1) | _BV(SPR0);
  report(STATUS_AFTER(1023));
  report(STATUS_AFTER(1024));
  end_program();
}
