// Counts its starts in two bytes of EEPROM, and echoes received bytes. Answers "t" with millis().
#include <EEPROM.h>

void setup() {
  Serial.begin(115200);
  const byte count = EEPROM.read(0) + 1;
  Serial.print(F("was "));
  Serial.print(EEPROM.read(0));
  Serial.print(' ');
  Serial.println(EEPROM.read(1));
  Serial.flush();
  EEPROM.write(0, count);
  EEPROM.write(1, count);
}

void loop() {
  if (!Serial.available()) return;
  const char c = Serial.read();
  if (c == 't') {
    Serial.println(millis());
  } else {
    Serial.print('<');
    Serial.print(c);
    Serial.print('>');
  }
}
