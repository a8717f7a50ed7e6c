#include <Wire.h>
// Follows the line's left edge by the clear channel of a TCS34725 under the robot's front.
#define TCS 0x29
#define CMD 0x80
const int enL = 5, inL1 = 7, inL2 = 8, enR = 6, inR1 = 9, inR2 = 10;
uint16_t white, black;

void put(byte reg, byte v) {
  Wire.beginTransmission(TCS); Wire.write(CMD | reg); Wire.write(v); Wire.endTransmission();
}
byte get8(byte reg) {
  Wire.beginTransmission(TCS); Wire.write(CMD | reg); Wire.endTransmission();
  Wire.requestFrom(TCS, 1);
  return Wire.read();
}
uint16_t clear() {
  Wire.beginTransmission(TCS); Wire.write(CMD | 0x20 | 0x14); Wire.endTransmission();
  Wire.requestFrom(TCS, 2);
  uint16_t low = Wire.read();
  return low | Wire.read() << 8;
}
void motors(int l, int r) {
  digitalWrite(inL1, l > 0); digitalWrite(inL2, l < 0); analogWrite(enL, abs(l));
  digitalWrite(inR1, r > 0); digitalWrite(inR2, r < 0); analogWrite(enR, abs(r));
}
void setup() {
  Serial.begin(9600);
  for (int p = 5; p <= 10; p++) pinMode(p, OUTPUT);
  Wire.begin();
  byte id = get8(0x12);
  Serial.print(F("id 0x")); Serial.println(id, HEX);
  put(0x01, 0xFF);      // integration time 2.4 ms
  put(0x0F, 0x02);      // gain 16
  put(0x00, 0x03);      // power on, ADC on
  delay(10);
  // turns left and right to find the readings of white and black
  white = 0; black = 65535;
  motors(-60, 60);
  for (int i = 0; i < 100; i++) { sample(); delay(3); }
  motors(60, -60);
  for (int i = 0; i < 200; i++) { sample(); delay(3); }
  motors(-60, 60);
  for (int i = 0; i < 100; i++) { sample(); delay(3); }
  motors(0, 0);
  Serial.print(F("black ")); Serial.print(black); Serial.print(F(" white ")); Serial.println(white);
}
void sample() {
  uint16_t c = clear();
  if (c > white) white = c;
  if (c < black) black = c;
}
void loop() {
  // 0 = black ... 100 = white; 50 = at the edge
  long share = 100L * ((long)clear() - black) / ((long)white - black);
  int error = constrain(share, 0, 100) - 50;
  motors(70 + error, 70 - error);
  delay(2);
}
