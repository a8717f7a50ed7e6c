#ifndef RobotMotor_h
#define RobotMotor_h
#include <Blinker.h>

#include "Arduino.h"

class RobotMotor {
 public:
  RobotMotor(uint8_t pwm, uint8_t direction);
  void begin();
  void set(int speed);

 private:
  uint8_t pwm_, direction_;
};
#endif
