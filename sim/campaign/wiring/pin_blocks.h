// Finds what the blocks of a sketch's functions write to pins, and concludes sides and directions of motors:
// moveForward() shows which level is forward, and `analogWrite(ENB, leftSpeed)` names the side of a pin.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/campaign/wiring/name_words.h"
#include "sim/campaign/wiring/source_blocks.h"

namespace robosim::wiring {

/// A call of digitalWrite() or analogWrite().
struct PinWrite {
  Pin pin = kNoPin;
  std::optional<int> level;   ///< 0 = LOW; otherwise HIGH, or the duty cycle; empty if it is not a constant
  bool is_pwm = false;        ///< an analogWrite()
  Side side = Side::unknown;  ///< the side that a comment or the value names
  int parameter = -1;         ///< position of the function's parameter that is the pin; -1 = none
  bool is_said_off = false;   ///< a comment says that this write stops the motor
};

struct PinBlock {
  std::string function;
  std::vector<std::string> words;  ///< words of the function's name
  bool shifts_out = false;         ///< calls shiftOut()
  int sense = 0;                   ///< 1: drives forward; -1: backward; 0: unknown
  std::vector<PinWrite> writes;
  bool runs = true;  ///< false if nothing calls the function
};

/// A motor's pins, as in RobotDraft. kNoPin = none.
struct MotorPins {
  Pin en = kNoPin, in1 = kNoPin, in2 = kNoPin;  ///< in1 may be a phase (direction) input
};

/// Resolves the words of the source.
struct Resolver {
  std::function<std::vector<Pin>(const std::string&)> pins_of;  ///< pins of an argument
  std::function<std::string(const std::string&)> value_of;      ///< value of a constant
};

/// Returns the blocks that write to pins. A block without writes gets the writes of the functions that
/// it calls.
std::vector<PinBlock> pin_blocks(const std::vector<SourceText>& sources, const Resolver& resolver);

// In the next functions, blocks that do not run count only if the other blocks leave the answer open.

/// Returns the side of a pin, if all blocks that name a side for it agree.
Side side_in_blocks(const std::vector<PinBlock>& blocks, Pin pin);
/// Returns 1 if in1 HIGH and in2 LOW drive forward, -1 for the reverse, 0 if the source leaves it open.
/// Functions and conditions that name the direction decide. Without them, a motor that the source turns in
/// only one direction turns forward.
int forward_in_blocks(const std::vector<PinBlock>& blocks, const MotorPins& motor);
/// Returns 1 if functions such as turnLeft() confirm that `left` is the left motor, -1 if they drive it as
/// the right one. `left_forward` and `right_forward` are results of forward_in_blocks().
int order_in_blocks(const std::vector<PinBlock>& blocks, const MotorPins& left, const MotorPins& right,
                    int left_forward, int right_forward);

}  // namespace robosim::wiring
