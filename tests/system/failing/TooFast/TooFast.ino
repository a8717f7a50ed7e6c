// Follows a line, too fast for the bends.
#include <LineKit.h>

const uint8_t SENSOR_PINS[] = {A0, A1, A2, A3, A4};

AnalogLineSensors sensors(SENSOR_PINS);
DriveMotors motors(DriveMotor(5, 7, 8), DriveMotor(6, 9, 10));

void setup() {
  Serial.begin(115200);
  sensors.begin();
  sensors.setRange(110, 880);
  motors.begin();
  Serial.println(F("go"));
}

void loop() {
  sensors.read();
  int turn = sensors.position() / 50;
  motors.drive(180 + turn, 180 - turn);
  delay(5);
}
