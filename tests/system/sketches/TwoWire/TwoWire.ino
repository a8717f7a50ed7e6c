// Writes to a display, a gyroscope and a missing device on the two-wire bus.
#include <Wire.h>

byte spoken(byte address) {
  Wire.beginTransmission(address);
  return Wire.endTransmission();
}

int read16(byte address, byte number) {
  Wire.beginTransmission(address);
  Wire.write(number);
  Wire.endTransmission(false);
  Wire.requestFrom(address, (byte)2);
  const byte high = Wire.read();
  return (int16_t)(high << 8 | Wire.read());
}

void set(byte address, byte number, byte value) {
  Wire.beginTransmission(address);
  Wire.write(number);
  Wire.write(value);
  Wire.endTransmission();
}

void half(byte lines, bool data) {
  Wire.beginTransmission(0x27);
  Wire.write(lines | 0x0C | data);
  Wire.write(lines | 0x08 | data);
  Wire.endTransmission();
  delay(2);
}

void lcd(byte value, bool data) {
  half(value & 0xF0, data);
  half(value << 4, data);
}

void setup() {
  Serial.begin(115200);
  Wire.begin();
  Wire.setClock(400000);
  Serial.print(spoken(0x27));
  Serial.print(spoken(0x68));
  Serial.println(spoken(0x50));
  Serial.println(Wire.requestFrom(0x50, 4));
  Serial.println(read16(0x68, 0x75) >> 8, HEX);
  set(0x68, 0x6B, 0);
  delay(2);
  Serial.println(read16(0x68, 0x3F) / 1000);  // 1 g plus noise
  delay(20);
  half(0x30, false);
  delay(5);
  half(0x30, false);
  half(0x30, false);
  half(0x20, false);
  lcd(0x28, false);
  lcd(0x0C, false);
  lcd(0x01, false);
  for (const char* c = "On the bus"; *c; ++c) lcd(*c, true);
}

void loop() {}
