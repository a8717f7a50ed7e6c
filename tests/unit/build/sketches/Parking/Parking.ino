// Sleeps between two control steps, and parks at the end.
#include <avr/cpufunc.h>
#include <avr/power.h>
#include <avr/sleep.h>
#include <avr/wdt.h>
#include <util/crc16.h>
#include <util/delay.h>
#include <util/parity.h>

#define sbi(sfr, bit) (_SFR_BYTE(sfr) |= _BV(bit))
#define cbi(sfr, bit) (_SFR_BYTE(sfr) &= ~_BV(bit))

void setup() {
  Serial.begin(115200);
  uint16_t crc = 0xFFFF;
  for (const char *c = "123456789"; *c; c++) crc = _crc16_update(crc, *c);
  Serial.println(crc, HEX);
  Serial.println(parity_even_bit(7));
  sbi(ADCSRA, ADPS2);
  cbi(ADCSRA, ADPS1);
  cbi(ADCSRA, ADPS0);
  set_sleep_mode(SLEEP_MODE_IDLE);
  wdt_enable(WDTO_2S);
  _delay_ms(2);
  _delay_us(1.5);
  delayMicroseconds(10);
  _NOP();
}

void loop() {
  wdt_reset();
  sleep_mode();
  if (millis() > 100) {
    Serial.println(F("parked"));
    Serial.flush();
    wdt_disable();
    power_all_disable();
    cli();
    sleep_enable();
    sleep_cpu();
  }
}
