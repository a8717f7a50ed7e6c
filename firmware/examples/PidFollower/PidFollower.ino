// Follows a line with five analog sensors and a PID controller.
//
// Hold the button while switching on to calibrate: the robot turns to and fro over the line for two seconds. Without it the
// sensors' range is the one below. Then it drives.

#include <LineKit.h>

const uint8_t SENSOR_PINS[] = {A0, A1, A2, A3, A4};  // left to right
const uint8_t BUTTON_PIN = 2;

const int16_t CRUISE = 170;        // of 255
const int16_t MOST_STEERING = 150; // of 255
const uint8_t STEP_MS = 5;

AnalogLineSensors sensors(SENSOR_PINS);
DriveMotors motors(DriveMotor(5, 7, 8), DriveMotor(6, 9, 10));
PushButton button(BUTTON_PIN);
PidController pid(60, 0, 4);  // PWM steps per sensor pitch; the derivative per pitch and second

// Turns to and fro, so that every sensor sees both floor and line.
void calibrate() {
  sensors.startCalibration();
  for (int i = 0; i < 400; i++) {
    bool to_the_left = i < 100 || i >= 300;
    motors.drive(to_the_left ? -90 : 90, to_the_left ? 90 : -90);
    sensors.calibrate();
    delay(STEP_MS);
  }
  motors.stop();
}

void setup() {
  sensors.begin();
  motors.begin();
  button.begin();
  pid.setLimits(-MOST_STEERING, MOST_STEERING);
  sensors.setRange(100, 800);
  if (button.isPressed()) calibrate();
}

void loop() {
  sensors.read();
  float off_centre = sensors.position() / 1000.0;  // in sensor pitches, positive: the line is to the right
  int16_t steering = pid.update(off_centre, STEP_MS / 1000.0);
  motors.drive(CRUISE + steering, CRUISE - steering);
  delay(STEP_MS);
}
