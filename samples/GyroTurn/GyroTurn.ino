#include <Wire.h>

// Reads an MPU-6050 by its registers. Turns four times by 90 degrees, then once by -180 degrees.
const int MPU = 0x68;
float gyroZ, offsetZ = 0, angle = 0;
unsigned long before;

void setup() {
  Serial.begin(115200);
  pinMode(5, OUTPUT); pinMode(7, OUTPUT); pinMode(8, OUTPUT);
  pinMode(6, OUTPUT); pinMode(9, OUTPUT); pinMode(10, OUTPUT);
  Wire.begin();
  Wire.setClock(400000);
  Wire.beginTransmission(MPU);
  Wire.write(0x6B);  // wake up
  Wire.write(0);
  if (Wire.endTransmission(true) != 0) {
    Serial.println("no MPU-6050!");
    while (1) delay(100);
  }
  Wire.beginTransmission(MPU);
  Wire.write(0x1B);
  Wire.write(0x08);  // 500 deg/s
  Wire.endTransmission(true);

  for (int i = 0; i < 200; i++) {
    offsetZ += readZ();
    delay(3);
  }
  offsetZ /= 200;
  Serial.print("offset "); Serial.println(offsetZ);
}

float readZ() {
  Wire.beginTransmission(MPU);
  Wire.write(0x47);
  Wire.endTransmission(false);
  Wire.requestFrom(MPU, 2, true);
  int16_t raw = Wire.read() << 8 | Wire.read();
  return raw / 65.5;
}

void spin(int s) {
  digitalWrite(7, s < 0); digitalWrite(8, s > 0);
  digitalWrite(9, s > 0); digitalWrite(10, s < 0);
  analogWrite(5, abs(s)); analogWrite(6, abs(s));
}

void turnBy(float target) {
  angle = 0;
  before = micros();
  while (abs(angle) < abs(target) - 1.5) {
    float rest = abs(target) - abs(angle);
    spin((target > 0 ? 1 : -1) * (rest > 30 ? 110 : 75));
    unsigned long now = micros();
    angle += (readZ() - offsetZ) * (now - before) * 1e-6;
    before = now;
  }
  spin(0);
  delay(400);
  Serial.print("turned "); Serial.println(angle, 0);
}

void loop() {
  for (int i = 0; i < 4; i++) turnBy(90);
  turnBy(-180);
  Serial.println("finished");
  while (true) ;
}
