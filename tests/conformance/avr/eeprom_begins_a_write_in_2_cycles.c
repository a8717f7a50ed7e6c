// A write to the EEPROM halts the processor for 2 cycles.
// Source: DS40002061B, 8.4
// Expect: 20 60
// Chips: atmega328p atmega2560
// Host: cycles
#include "report.h"

// A frame of the USART takes 160 cycles. Between the frame's start and the read of the status, the code takes
// 8 cycles besides the delay: SBI 2, SBI 2, halt 2, LDS 2.
#define STATUS_AFTER(cycles)                  \
  ({                                          \
    while (EECR & _BV(EEPE)) {                \
    }                                         \
    UCSR0A = _BV(TXC0);                       \
    UDR0 = 0;                                 \
    EECR |= _BV(EEMPE);                       \
    EECR |= _BV(EEPE);                        \
    __builtin_avr_delay_cycles((cycles) - 8); \
    uint8_t status = UCSR0A;                  \
    status;                                   \
  })

int main(void) {
  UCSR0B = _BV(TXEN0);
  report(STATUS_AFTER(159));
  report(STATUS_AFTER(160));
  end_program();
}
