// In power-down the watchdog runs and wakes the chip; the USART stops, and continues its frame after the
// start-up time.
// Source: DS40002061B, 10.5, 9.2
// Expect: dd 20 60
// Ends: 1000000
// Chips: atmega328p atmega2560
// Host: not simulated: sleep modes other than idle
#include "report.h"

ISR(WDT_vect) {
  WDTCSR = 0;
  report(0xDD);
}

int main(void) {
  UCSR0B = _BV(TXEN0);
  UBRR0 = 99;  // a frame of 16000 cycles
  WDTCSR = _BV(WDIE);
  SMCR = _BV(SM1) | _BV(SE);
  sei();
  UDR0 = 0;
  sleep_cpu();
  report(UCSR0A);
  __builtin_avr_delay_cycles(16000);
  report(UCSR0A);
  end_program();
}
