// Follows a line with five analog sensors and a PID controller.
//
// The robot starts immediately, with the sensor range given below. To measure the range first, hold the
// button while switching on: the robot then turns left and right over the line for two seconds.

#include <LineKit.h>

const uint8_t SENSOR_PINS[] = {A0, A1, A2, A3, A4};  // left to right
const uint8_t BUTTON_PIN = 4;                        // to ground

const uint8_t STEP_MS = 5;
const float CRUISE = 140;   // duty cycle, of 255, when the line is under the middle sensor
const float SLOWER = 40;    // speed reduction per sensor pitch between line and middle sensor
const float SLOWEST = 60;   // lower limit of the speed
const float STEERING = 200; // upper limit of the steering

AnalogLineSensors sensors(SENSOR_PINS);
DriveMotors motors(DriveMotor(5, 7, 8), DriveMotor(6, 9, 10));
PushButton button(BUTTON_PIN);
PidController pid(80, 0, 3);  // kp: PWM steps per sensor pitch; kd: PWM steps per (pitch / second)

void measure_range() {
  sensors.startCalibration();
  for (int i = 0; i < 400; i++) {
    int turn = i < 100 || i >= 300 ? 60 : -60;
    motors.drive(-turn, turn);
    sensors.calibrate();
    delay(STEP_MS);
  }
  motors.drive(0, 0);
}

void setup() {
  sensors.begin();
  sensors.setRange(110, 880);  // on the floor, on the line
  motors.begin();
  pid.setLimits(-STEERING, STEERING);
  button.begin();
  if (button.isPressed()) measure_range();
}

void loop() {
  sensors.read();
  float off = sensors.position() / 1000.0;  // in sensor pitches; positive if the line is to the right
  float speed = max(SLOWEST, CRUISE - SLOWER * abs(off));
  float turn = pid.update(off, STEP_MS / 1000.0);
  motors.drive(speed + turn, speed - turn);
  delay(STEP_MS);
}
