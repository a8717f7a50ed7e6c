// The robot: three sensors that see the line, a collision sensor, and behind a chain of three shift registers
// two motors, two digits, three LEDs and a buzzer.
//
// Motors are driven in pulses: on for some milliseconds of every period, and in between the driver brakes. A
// duty is milliseconds of kPeriod; negative is backward. At 14 of 30 the robot runs at about 12 cm/s.
//
// Everything happens in step(): it switches the motors, waits for the next step's time, and looks at the
// sensors. While the collision sensor is pressed it pauses, for up to kPatienceMs; then it is blocked.
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

  /// One step with these duties, -kPeriod..kPeriod.
  void step(int8_t left, int8_t right);
  /// Steps at rest.
  void rest(uint16_t ms);

  /// Whether a sensor is over the line: two looks in a row have said so.
  bool left() const { return seen_ & 1; }
  bool middle() const { return seen_ & 2; }
  bool right() const { return seen_ & 4; }
  /// Steps since the robot was switched on: the clock of all that moves.
  uint16_t now() const { return steps_; }
  /// Whether something has stood in the way for kPatienceMs. True until forgiven.
  bool blocked() const { return blocked_; }
  void forgive() { blocked_ = false; }

  void light(uint8_t lights);
  /// Shows 0..99; anything more is two dashes.
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
