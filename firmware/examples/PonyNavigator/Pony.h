// The robot's hardware: three line sensors and a collision sensor. A chain of three shift registers drives
// two motors, two digits, three LEDs and a buzzer.
//
// The motors are driven by slow PWM: on for some milliseconds of every period, then braked by the driver. A
// duty is this on-time in ms (of kPeriod ms); negative is backward. A duty of 14 drives at about 12 cm/s.
//
// step() does all work: it switches the motors, waits until the next step is due, and reads the sensors.
// While the collision sensor is pressed, step() waits for up to kPatienceMs. If the sensor is still pressed
// after that time, blocked() becomes true.
#ifndef PONY_H
#define PONY_H

#include <ShiftRegisters.h>

class Pony {
 public:
  static const uint8_t kStepMs = 2;
  static const uint8_t kPeriod = 30;
  static const uint16_t kPatienceMs = 5000;

  enum Light : uint8_t { kJunctionLight = 1, kEndLight = 2, kLineLight = 4 };

  void begin();

  /// Performs one step with these duties, -kPeriod..kPeriod.
  void step(int8_t left, int8_t right);
  /// Stands still for `ms` milliseconds.
  void rest(uint16_t ms);

  /// Return whether this sensor is over the line. A new state counts after two equal readings.
  bool left() const { return seen_ & 1; }
  bool middle() const { return seen_ & 2; }
  bool right() const { return seen_ & 4; }
  /// Returns the number of steps since power-on, the time base of all motion.
  uint16_t now() const { return steps_; }
  /// Returns whether an obstacle has been in the way for kPatienceMs. Stays true until forgive().
  bool blocked() const { return blocked_; }
  void forgive() { blocked_ = false; }

  void light(uint8_t lights);
  /// Shows 0..99, or two dashes for a greater number.
  void show(uint8_t number);
  void beep(uint16_t ms);

 private:
  void drive(uint8_t code);
  void pause();
  uint8_t look() const;

  ShiftRegisters out_ = ShiftRegisters(11, 13, 10, 3);
  uint8_t seen_ = 0, seen_before_ = 0;
  uint8_t phase_ = 0;
  uint16_t steps_ = 0;
  uint16_t beep_steps_ = 0;
  bool blocked_ = false;
  uint32_t next_us_ = 0;
};

#endif
