// A byte and its acknowledgement take 9 periods of SCL: 9 (16 + 2 TWBR 4^TWPS) cycles.
// Source: DS40002061B, 21.5.2, 21.5.4
// Expect: 04 84
// Chips: atmega328p atmega2560 atmega32u4
#include "report.h"

// 9 * (16 + 2 * 3 * 4) = 360 cycles; LDS takes 2.
#define CONTROL_AFTER(cycles)                         \
  ({                                                  \
    TWCR = _BV(TWINT) | _BV(TWEN) | _BV(TWSTA);       \
    while (!(TWCR & _BV(TWINT))) {                    \
    }                                                 \
    TWDR = 0x40;                                      \
    TWCR = _BV(TWINT) | _BV(TWEN);                    \
    __builtin_avr_delay_cycles((cycles) - 2);         \
    uint8_t control = TWCR;                           \
    __builtin_avr_delay_cycles(400);                  \
    control;                                          \
  })

int main(void) {
  TWBR = 3;
  TWSR = _BV(TWPS0);
  report(CONTROL_AFTER(359));
  report(CONTROL_AFTER(360));
  end_program();
}
