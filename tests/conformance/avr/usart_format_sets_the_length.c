// A frame has a start bit, 5 to 9 data bits, a parity bit if selected, and 1 or 2 stop bits; U2X halves the
// bit time.
// Source: DS40002061B, 20.3.1, 20.4, 20.6.2
// Expect: 00 40 00 40 00 40
// Chips: atmega328p atmega2560
#include "report.h"

#define STATUS_AFTER(cycles)                  \
  ({                                          \
    UCSR0A = _BV(TXC0) | (UCSR0A & _BV(U2X0)); \
    UDR0 = 0x55;                              \
    __builtin_avr_delay_cycles((cycles) - 2); \
    uint8_t status = UCSR0A;                  \
    __builtin_avr_delay_cycles(1000);         \
    status & _BV(TXC0);                       \
  })

int main(void) {
  UCSR0B = _BV(TXEN0);
  UCSR0C = 0;  // 5N1: 7 bits
  report(STATUS_AFTER(7 * 16 - 1));
  report(STATUS_AFTER(7 * 16));
  UCSR0B = _BV(TXEN0) | _BV(UCSZ02);
  UCSR0C = _BV(UCSZ01) | _BV(UCSZ00) | _BV(UPM01) | _BV(USBS0);  // 9E2: 13 bits
  report(STATUS_AFTER(13 * 16 - 1));
  report(STATUS_AFTER(13 * 16));
  UCSR0A = _BV(U2X0);
  UBRR0 = 2;
  report(STATUS_AFTER(13 * 8 * 3 - 1));
  report(STATUS_AFTER(13 * 8 * 3));
  end_program();
}
