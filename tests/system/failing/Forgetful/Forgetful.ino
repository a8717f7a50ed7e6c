// Selects a speed by the number of sensors on the line. If there are none, reads through a null pointer.
#include <LineKit.h>

const uint8_t SENSOR_PINS[] = {A0, A1, A2};

DigitalLineSensors sensors(SENSOR_PINS, HIGH);
DriveMotors motors(DriveMotor(5, 7, 8), DriveMotor(6, 9, 10));

void setup() {
  Serial.begin(115200);
  sensors.begin();
  motors.begin();
  Serial.println(F("touring"));
}

const int SPEEDS[] = {360, 180, 120};
const int* speedOn(int lines) { return lines > 0 ? &SPEEDS[lines - 1] : nullptr; }

void loop() {
  sensors.read();
  int lines = 0;
  for (uint8_t i = 0; i < 3; i++) lines += sensors.onLine(i);
  int speed = *speedOn(lines);
  motors.drive(speed / (sensors.onLine(0) ? 3 : 2), speed / (sensors.onLine(2) ? 3 : 2));
  delay(5);
}
