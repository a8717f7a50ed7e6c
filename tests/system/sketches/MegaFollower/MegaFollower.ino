// Follows a line with pins that an Uno does not have. Motors are on pins 22 and above, sensors on A8 to A12,
// encoders on 20 and 21. A second serial port sends a log.

#include <LineKit.h>

const uint8_t SENSOR_PINS[] = {A8, A9, A10, A11, A12};

AnalogLineSensors sensors(SENSOR_PINS);
DriveMotors motors(DriveMotor(44, 22, 23), DriveMotor(45, 24, 25));
PidController pid(80, 0, 3);

volatile unsigned int left_edges, right_edges;
void countLeft() { ++left_edges; }
void countRight() { ++right_edges; }

void setup() {
  Serial.begin(115200);
  Serial1.begin(57600);
  sensors.begin();
  sensors.setRange(110, 880);
  motors.begin();
  pid.setLimits(-200, 200);
  attachInterrupt(digitalPinToInterrupt(20), countLeft, CHANGE);
  attachInterrupt(digitalPinToInterrupt(21), countRight, CHANGE);
}

void loop() {
  static unsigned int rounds = 0;
  sensors.read();
  const float off = sensors.position() / 1000.0;
  const float turn = pid.update(off, 0.005);
  motors.drive(120 + turn, 120 - turn);
  if (++rounds % 50 == 0) Serial1.println(off);
  if (rounds == 400) Serial.println(left_edges > 300 && right_edges > 300 ? "both wheels turn" : "a wheel stands");
  delay(5);
}
