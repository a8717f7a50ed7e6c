#include "Lcd.h"

#define BACKLIGHT 0x08
#define ENABLE 0x04

void Lcd::nibble(byte value, byte rs) {
  byte out = (value & 0xF0) | BACKLIGHT | rs;
  Wire.beginTransmission(address);
  Wire.write(out | ENABLE);
  Wire.write(out);
  Wire.endTransmission();
}

void Lcd::send(byte value, byte rs) {
  nibble(value, rs);
  nibble(value << 4, rs);
}

void Lcd::begin() {
  Wire.begin();
  delay(50);
  for (byte i = 0; i < 3; i++) {
    nibble(0x30, 0);
    delay(5);
  }
  nibble(0x20, 0);
  send(0x28, 0);   // 4 bits, 2 lines
  send(0x0C, 0);   // on, no cursor
  send(0x06, 0);
  clear();
}
