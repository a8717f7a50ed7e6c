// Measures how far two wheels have turned, with one encoder channel per wheel: two wires.
//
// Both edges of each channel count, by interrupts (pins 2 and 3 on an Uno), so no edge is missed, whatever
// the sketch does. A single channel cannot indicate the direction: a wheel is assumed to turn as it was last
// driven. So let a wheel stop before you reverse it.
//
//   mm = counts * pi * wheel diameter / (2 * periods per turn of the wheel)
//
// A sketch can have only one pair of encoders.
//
//   WheelEncoders encoders(2, 3);
//   void setup() { encoders.begin(); }
//   void loop() {
//     motors.drive(left, right);
//     encoders.setDirections(left, right);
//     left_counts += encoders.takeLeft();
//   }
#ifndef LINEKIT_WHEEL_ENCODERS_H
#define LINEKIT_WHEEL_ENCODERS_H

#include <Arduino.h>

class WheelEncoders {
 public:
  WheelEncoders(uint8_t left_pin, uint8_t right_pin) : left_pin_(left_pin), right_pin_(right_pin) {}

  void begin();
  /// Sets the direction of each wheel by the sign of its value; 0 leaves the direction unchanged.
  void setDirections(int16_t left, int16_t right);
  /// Return the counts since the last call, forward positive.
  int16_t takeLeft() { return take(left_); }
  int16_t takeRight() { return take(right_); }

 private:
  struct Wheel {
    volatile int16_t counts;
    volatile int8_t step;
  };
  static int16_t take(Wheel& wheel);
  static void onLeft() { left_.counts = static_cast<int16_t>(left_.counts + left_.step); }
  static void onRight() { right_.counts = static_cast<int16_t>(right_.counts + right_.step); }

  static Wheel left_, right_;

  uint8_t left_pin_, right_pin_;
};

#endif
