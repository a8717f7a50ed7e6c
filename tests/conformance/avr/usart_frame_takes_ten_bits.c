// A frame of 8N1 takes 10 bits of 16 (UBRR + 1) cycles; TXC is set at its end.
// Source: DS40002061B, 20.3.1, 20.6.3
// Expect: 20 60
// Chips: atmega328p atmega2560
#include "report.h"

// A frame takes 160 cycles; LDS reads 2 cycles after the delay.
#define STATUS_AFTER(cycles)                    \
  ({                                            \
    UCSR0A = _BV(TXC0);                         \
    UDR0 = 0x55;                                \
    __builtin_avr_delay_cycles((cycles) - 2);   \
    uint8_t status = UCSR0A;                    \
    __builtin_avr_delay_cycles(500);            \
    status;                                     \
  })

int main(void) {
  UCSR0B = _BV(TXEN0);
  report(STATUS_AFTER(159));
  report(STATUS_AFTER(160));
  end_program();
}
