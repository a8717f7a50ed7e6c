#include <Wire.h>
#include "font.h"

// Shows the time on a 0.96" OLED (SSD1306) while the robot drives, without a library.
#define OLED 0x3C
int leftPwm = 5, leftFwd = 7, leftBack = 8, rightPwm = 6, rightFwd = 9, rightBack = 10;

void command(uint8_t c) {
  Wire.beginTransmission(OLED);
  Wire.write(0x00);
  Wire.write(c);
  Wire.endTransmission();
}

const uint8_t init_sequence[] PROGMEM = {0xAE, 0xD5, 0x80, 0xA8, 0x3F, 0xD3, 0x00, 0x40, 0x8D, 0x14, 0x20, 0x02,
                                         0xA1, 0xC8, 0xDA, 0x12, 0x81, 0xCF, 0xD9, 0xF1, 0xDB, 0x40, 0xA4, 0xA6, 0xAF};

void oledBegin() {
  for (uint8_t i = 0; i < sizeof init_sequence; i++) command(pgm_read_byte(&init_sequence[i]));
  for (uint8_t page = 0; page < 8; page++) {
    at(page, 0);
    for (uint8_t n = 0; n < 8; n++) {
      Wire.beginTransmission(OLED);
      Wire.write(0x40);
      for (uint8_t i = 0; i < 16; i++) Wire.write(0);
      Wire.endTransmission();
    }
  }
}

void at(uint8_t page, uint8_t column) {
  command(0xB0 | page);
  command(column & 0x0F);
  command(0x10 | column >> 4);
}

void text(const char* s) {
  for (; *s; s++) {
    Wire.beginTransmission(OLED);
    Wire.write(0x40);
    for (uint8_t i = 0; i < 5; i++) Wire.write(pgm_read_byte(&font[(*s - ' ') * 5 + i]));
    Wire.write(0);
    Wire.endTransmission();
  }
}

void setup() {
  for (int p = 5; p <= 10; p++) pinMode(p, OUTPUT);
  Wire.begin();
  Wire.setClock(400000);
  oledBegin();
  at(0, 0);
  text("ROBOT 7");
  delay(1000);
}

unsigned long last = 0;
void loop() {
  bool l = digitalRead(A0), m = digitalRead(A1), r = digitalRead(A2);
  int speedL = 115, speedR = 115;
  if (l && !r) speedL = -90;
  if (r && !l) speedR = -90;
  digitalWrite(leftFwd, speedL > 0); digitalWrite(leftBack, speedL < 0);
  digitalWrite(rightFwd, speedR > 0); digitalWrite(rightBack, speedR < 0);
  analogWrite(leftPwm, abs(speedL));
  analogWrite(rightPwm, abs(speedR));

  if (millis() - last >= 1000) {
    last += 1000;
    char line[12];
    sprintf(line, "TIME %3lu S", millis() / 1000);
    at(2, 0);
    text(line);
  }
}
