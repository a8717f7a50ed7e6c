// Makes one full turn by its gyroscope, drives ahead while its middle sensor sees the line, and stops. A letter
// on the serial line selects how it uses the gyroscope's value:
//   n  unchanged         o  minus the value at rest, the mean of 200 readings
#include <Wire.h>

const int MPU = 0x68;

void set(byte number, byte value) {
  Wire.beginTransmission(MPU);
  Wire.write(number);
  Wire.write(value);
  Wire.endTransmission(true);
}

// Returns the rate of turn in deg/s.
float turning() {
  Wire.beginTransmission(MPU);
  Wire.write(0x47);
  Wire.endTransmission(false);
  Wire.requestFrom(MPU, 2, true);
  const int16_t raw = Wire.read() << 8 | Wire.read();
  return raw / 32.8;
}

void drive(int left, int right) {
  digitalWrite(7, left >= 0);
  digitalWrite(8, left < 0);
  digitalWrite(9, right >= 0);
  digitalWrite(10, right < 0);
  analogWrite(5, abs(left));
  analogWrite(6, abs(right));
}

void stop() {
  for (byte pin = 7; pin <= 10; pin++) digitalWrite(pin, HIGH);
  analogWrite(5, 255);
  analogWrite(6, 255);
  delay(300);
}

void setup() {
  for (byte pin = 5; pin <= 10; pin++) pinMode(pin, OUTPUT);
  Serial.begin(115200);
  while (!Serial.available()) {}
  const char way = Serial.read();
  Wire.begin();
  set(0x6B, 0x00);
  set(0x1B, 0x10);
  float offset = 0;
  for (int i = 0; i < 200 && way == 'o'; i++) {
    offset += turning() / 200;
    delay(2);
  }
  float angle = 0;
  unsigned long before = micros();
  drive(-100, 100);
  while (angle < 320) {  // the robot coasts for another 37 degrees
    if (angle > 270) drive(-75, 75);
    const unsigned long now = micros();
    angle += (turning() - offset) * (now - before) * 1e-6;
    before = now;
  }
  stop();
  drive(130, 130);
  while (digitalRead(A1)) {}
  stop();
}

void loop() {}
