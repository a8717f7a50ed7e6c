// Tours a floor by the left-hand rule. Mistakes the first branch on the left, or a bend, for the end of the
// line. The detection of branches is debounced, so the same worlds fail with every compiler.
#include <LineKit.h>

const uint8_t SENSOR_PINS[] = {A0, A1, A2};  // left, middle, right; HIGH on the line

DigitalLineSensors sensors(SENSOR_PINS, HIGH);
DriveMotors motors(DriveMotor(5, 7, 8), DriveMotor(6, 9, 10));
PathFollower path(PathFollower::Side::left);

void setup() {
  Serial.begin(115200);
  sensors.begin();
  motors.begin();
}

void loop() {
  sensors.read();
  path.update(sensors.onLine(0), sensors.onLine(1), sensors.onLine(2), millis());
  if (path.branches() > 0) {
    motors.drive(0, 0);
    Serial.println(F("the line ends here"));
    while (true) delay(1000);
  }
  motors.drive(path.leftSpeed(), path.rightSpeed());
  delay(2);
}
