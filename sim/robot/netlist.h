// The wires between the microcontroller and the parts: the board's pins, and the outputs of the robot's shift
// registers. A part that follows a level does not need to know which of the two it is wired to.
//
//   number                 wire
//   0 .. kMaxPins - 1      the board's pin of that number
//   kMaxPins + 8 r + q     output Qq of the robot's shift register number r, in the file's order
#pragma once

#include <string>
#include <vector>

#include "hal/board/robot_port.h"
#include "sim/base/kept.h"

namespace robosim::robot {

constexpr int kRegisterOutputs = 8;  ///< of one shift register: Q0 .. Q7
constexpr int kMostRegisters = 16;   ///< of one robot

/// The wire at output `q` of shift register number `index`.
constexpr Pin output_pin(int index, int q) {
  return static_cast<Pin>(kMaxPins + kRegisterOutputs * index + q);
}
constexpr bool is_output(Pin pin) { return pin >= kMaxPins && pin != kNoPin; }
/// Its name as robot files write it, "REG1.Q4"; `registers` are the robot's, in their order.
std::string output_name(const std::vector<std::string>& registers, Pin output);
static_assert(output_pin(kMostRegisters, 0) < kNoPin);

class Netlist {
 public:
  Netlist(RobotPort& board, std::size_t registers, Kept& kept)
      : board_(board), watchers_(registers * kRegisterOutputs) {
    state_.outputs.resize(watchers_.size());
    kept.add(state_);
  }

  /// How a wire is driven. A shift register's output that is switched off is not driven.
  const PinDrive& drive(Pin pin) const {
    return is_output(pin) ? state_.outputs[index_of(pin)] : board_.drive(pin);
  }
  /// As RobotPort::watch.
  void watch(Pin pin, PinWatcher& watcher);
  /// For shift registers: drives an output. Watchers are told if it has changed.
  void drive_output(Pin output, const PinDrive& drive, SimTime t);

 private:
  static std::size_t index_of(Pin output) { return static_cast<std::size_t>(output - kMaxPins); }

  struct State {
    std::vector<PinDrive> outputs;
  };

  RobotPort& board_;
  std::vector<std::vector<PinWatcher*>> watchers_;
  State state_;
};

}  // namespace robosim::robot
