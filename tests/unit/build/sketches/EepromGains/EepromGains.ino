// Stores gains in EEPROM.
#include <EEPROM.h>
#include <avr/eeprom.h>

struct Gains {
  float kp, ki, kd;
};

uint16_t EEMEM runs;

void setup() {
  Serial.begin(9600);
  Gains gains = {0.1, 0, 0.5};
  if (EEPROM.read(100) != 42) {
    EEPROM.put(101, gains);
    EEPROM.write(100, 42);
  }
  EEPROM.get(101, gains);
  EEPROM.update(500, EEPROM[500] == 0xFF ? 1 : EEPROM[500] + 1);
  EEPROM[501]++;
  int used = 0;
  for (int i = 0; i < EEPROM.length(); i++)
    if (EEPROM[i] != 0xFF) used++;
  eeprom_write_word(&runs, eeprom_read_word(&runs) + 1);
  Serial.println(gains.kd);
  Serial.println(used);
}

void loop() {}
