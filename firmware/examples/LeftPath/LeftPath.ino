// Tours a floor of lines with three digital sensors: takes the left branch wherever there is one, and turns round at the end of a
// line. Without closed loops it so visits every station and comes home. PathFollower.h says how and why.

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
