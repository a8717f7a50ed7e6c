// Drives the two motors of a robot with a wheel on each side.
//
// A motor driver (H-bridge) needs two inputs for each motor: a direction and a duty cycle, the share of time
// for which the motor is connected to the battery. There are two common ways to wire a driver. The number of
// pins that you pass to DriveMotor selects the way:
//
//   DriveMotor(en, in1, in2)   L298N: EN gets the PWM, IN1 HIGH and IN2 LOW is forward.
//                              TB6612: as L298N, with its PWM pin as `en`; its STBY pin must be HIGH
//                              (see DriveMotors).
//   DriveMotor(in1, in2)       DRV8833, L9110S, L298N with its EN jumpers left on: PWM on IN1
//                              drives forward, on IN2 backward.
//
// Connect PWM inputs to pins that support PWM: 3, 5, 6, 9, 10, 11 on an Uno.
//
// Speeds are -255 (full backward) .. 255 (full forward); larger values are limited. They are duty cycles, not
// metres per second. A motor needs a minimum duty cycle to turn at all (about 30 to 60 with an L298N). After
// setSmallestDuty(), speed 1 just turns the motor and 255 is full speed:
//
//   duty = smallest + (255 - smallest) * speed / 255
//
// Speed 0 shorts the motor, which brakes it. (An L298N brakes only a fast motor, because of the voltage drop
// in the driver.)
//
// If a motor runs the wrong way, swap its two wires, swap its two pins here, or call setReversed(true).
//
// Example:
//
//   DriveMotors motors(DriveMotor(5, 7, 8), DriveMotor(6, 9, 10));
//   void setup() { motors.begin(); motors.drive(150, 150); delay(500); motors.stop(); }
#ifndef LINEKIT_DRIVE_MOTORS_H
#define LINEKIT_DRIVE_MOTORS_H

#include <Arduino.h>

class DriveMotor {
 public:
  static const uint8_t kNoPin = 255;

  /// Uses a driver with an enable (or PWM) pin and two direction pins.
  DriveMotor(uint8_t enable, uint8_t in1, uint8_t in2) : enable_(enable), in1_(in1), in2_(in2) {}
  /// Uses a driver with PWM on its two inputs.
  DriveMotor(uint8_t in1, uint8_t in2) : enable_(kNoPin), in1_(in1), in2_(in2) {}

  void setReversed(bool reversed) { reversed_ = reversed; }
  /// Sets the duty cycle, 0..254, at which the motor just turns.
  void setSmallestDuty(uint8_t duty) { smallest_ = duty < 255 ? duty : 254; }

  /// Configures the pins as outputs, with the motor off.
  void begin();
  /// Drives at -255..255; 0 brakes.
  void drive(int16_t speed);
  /// Switches the motor off and lets it coast. Stopping takes longer than with drive(0).
  void coast();

  /// Returns the duty cycle for a speed of 0..255, by the formula above.
  static uint8_t dutyFor(uint8_t speed, uint8_t smallest);

 private:
  uint8_t enable_, in1_, in2_;
  uint8_t smallest_ = 0;
  bool reversed_ = false;
};

class DriveMotors {
 public:
  /// `standby` is a TB6612's STBY (or a DRV8833's SLEEP) pin, which begin() sets HIGH. Omit it if the pin is
  /// wired to 5 V.
  DriveMotors(const DriveMotor& left, const DriveMotor& right, uint8_t standby = DriveMotor::kNoPin)
      : left_(left), right_(right), standby_(standby) {}

  void begin();
  /// Drives each motor at -255..255. Equal speeds drive straight, opposite speeds turn on the spot.
  void drive(int16_t left, int16_t right) {
    left_.drive(left);
    right_.drive(right);
  }
  void stop() { drive(0, 0); }
  void coast() {
    left_.coast();
    right_.coast();
  }
  void setReversed(bool left, bool right) {
    left_.setReversed(left);
    right_.setReversed(right);
  }
  void setSmallestDuty(uint8_t duty) {
    left_.setSmallestDuty(duty);
    right_.setSmallestDuty(duty);
  }

 private:
  DriveMotor left_, right_;
  uint8_t standby_;
};

#endif
