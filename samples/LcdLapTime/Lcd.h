// Drives an LCD 1602 over I2C in 4-bit mode, without a library.
#pragma once
#include <Arduino.h>
#include <Wire.h>

class Lcd : public Print {
 public:
  Lcd(byte address) : address(address) {}
  void begin();
  void clear() { send(0x01, 0); delay(2); }
  void setCursor(byte column, byte row) { send(0x80 | (column + row * 0x40), 0); }
  virtual size_t write(uint8_t c) { send(c, 1); return 1; }
  using Print::write;

 private:
  void send(byte value, byte rs);
  void nibble(byte value, byte rs);
  byte address;
};
