#include <avr/wdt.h>
#include <avr/sleep.h>
#include <EEPROM.h>

// Counts restarts in the EEPROM. Hangs once, intentionally, after 2 s; the watchdog then restarts the chip.
// Sleeps until the button is pressed.
byte starts;

ISR(INT0_vect) {}

void sleepUntilPressed() {
  EICRA = 0;                 // low level on INT0 (pin 2) wakes the chip
  set_sleep_mode(SLEEP_MODE_PWR_DOWN);
  cli();
  sleep_enable();
  EIMSK = _BV(INT0);
  sei();
  sleep_cpu();
  sleep_disable();
  EIMSK = 0;
}

void setup() {
  MCUSR = 0;
  wdt_disable();
  starts = EEPROM.read(0) + 1;    // an erased EEPROM contains 0xFF
  EEPROM.write(0, starts);
  Serial.begin(9600);
  Serial.print("start ");
  Serial.println(starts);
  Serial.flush();
  pinMode(2, INPUT_PULLUP);
  for (byte p = 5; p <= 10; p++) pinMode(p, OUTPUT);
  digitalWrite(7, HIGH);
  digitalWrite(9, HIGH);
  if (starts == 0) sleepUntilPressed();
  wdt_enable(WDTO_250MS);
}

void loop() {
  wdt_reset();
  bool l = digitalRead(A0), r = digitalRead(A2);
  analogWrite(5, l ? 0 : 100);
  analogWrite(6, r ? 0 : 100);
  if (starts == 0 && millis() > 2000) {
    for (;;) ;                    // the intentional hang
  }
}
