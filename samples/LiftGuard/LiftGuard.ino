// Drives in a circle. Stops the motors while an MPU-6050 reports a tilt, and for one second afterwards.
#include <Wire.h>

const byte MPU = 0x68;
bool up = false;

void setReg(byte reg, byte value) {
  Wire.beginTransmission(MPU);
  Wire.write(reg);
  Wire.write(value);
  Wire.endTransmission();
}

void readAll(int16_t v[6]) {
  Wire.beginTransmission(MPU);
  Wire.write(0x3B);
  Wire.endTransmission(false);
  Wire.requestFrom(MPU, (byte)14);
  for (byte i = 0; i < 7; i++) {
    byte high = Wire.read();
    int16_t word = high << 8 | Wire.read();
    if (i < 3) v[i] = word;
    else if (i > 3) v[i - 1] = word;   // i == 3 is the temperature
  }
}

void drive(int l, int r) {
  digitalWrite(7, l > 0); digitalWrite(8, LOW);
  digitalWrite(9, r > 0); digitalWrite(10, LOW);
  analogWrite(5, l);
  analogWrite(6, r);
}

void setup() {
  Serial.begin(115200);
  for (byte p = 5; p <= 10; p++) pinMode(p, OUTPUT);
  Wire.begin();
  setReg(0x6B, 0);      // wake up
  setReg(0x1A, 3);      // 44 Hz low-pass
  delay(100);
}

void loop() {
  int16_t v[6];
  readAll(v);
  float roll = atan2(v[1], v[2]) * 57.3, pitch = atan2(-(float)v[0], sqrt((float)v[1] * v[1] + (float)v[2] * v[2])) * 57.3;
  bool tilted = fabs(roll) > 15 || fabs(pitch) > 15;
  static float fastest = 0;
  static unsigned long since = 0;
  fastest = max(fastest, (float)(abs((long)v[3]) + abs((long)v[4])) / 131);
  if (tilted) since = millis();
  if (tilted && !up) {
    up = true;
    drive(0, 0);
    Serial.print(F("put me down! "));
    Serial.println(fabs(roll) > fabs(pitch) ? (roll > 0 ? F("right") : F("left")) : (pitch > 0 ? F("nose down") : F("nose up")));
  } else if (up && millis() - since > 1000) {
    up = false;
    Serial.println(fastest > 150 ? F("that was fast") : F("thank you"));
    fastest = 0;
  } else if (!up) {
    drive(140, 150);
  }
  delay(10);
}
