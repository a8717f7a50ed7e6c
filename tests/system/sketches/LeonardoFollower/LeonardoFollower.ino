// Follows a line with pins that differ on a Leonardo: analog inputs on digital pins, PWM on 13 and 5,
// encoders on 0 and 1, which are free because Serial is USB.

#include <LineKit.h>

const uint8_t SENSOR_PINS[] = {A6, A8, A9, A10, A11};

AnalogLineSensors sensors(SENSOR_PINS);
DriveMotors motors(DriveMotor(5, 7, 14), DriveMotor(13, 15, 16));
PidController pid(80, 0, 3);

volatile unsigned int left_edges, right_edges;
void countLeft() { ++left_edges; }
void countRight() { ++right_edges; }

void setup() {
  Serial.begin(9600);
  sensors.begin();
  sensors.setRange(110, 880);
  motors.begin();
  pid.setLimits(-200, 200);
  attachInterrupt(digitalPinToInterrupt(0), countLeft, CHANGE);
  attachInterrupt(digitalPinToInterrupt(1), countRight, CHANGE);
}

void loop() {
  static unsigned int rounds = 0;
  sensors.read();
  const float off = sensors.position() / 1000.0;
  const float turn = pid.update(off, 0.005);
  motors.drive(120 + turn, 120 - turn);
  if (++rounds == 400) Serial.println(left_edges > 300 && right_edges > 300 ? "both wheels turn" : "a wheel stands");
  delay(5);
}
