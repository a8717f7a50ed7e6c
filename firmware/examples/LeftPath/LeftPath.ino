// Tours a floor of lines with three digital sensors: takes every left branch, and turns at a line's end.
// If the lines form no loop, the robot visits every station and returns home. PathFollower.h explains why.

#include <LineKit.h>

const uint8_t SENSOR_PINS[] = {A0, A1, A2};  // left, middle, right; HIGH on the line

DigitalLineSensors sensors(SENSOR_PINS, HIGH);
DriveMotors motors(DriveMotor(5, 7, 8), DriveMotor(6, 9, 10));
PathFollower path(PathFollower::Side::left);

void setup() {
  sensors.begin();
  motors.begin();
}

void loop() {
  sensors.read();
  path.update(sensors.onLine(0), sensors.onLine(1), sensors.onLine(2), millis());
  motors.drive(path.leftSpeed(), path.rightSpeed());
  delay(2);
}
