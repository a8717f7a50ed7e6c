// The wires between the microcontroller and the parts: the board's pins, and the outputs of the robot's shift
// registers and PWM drivers. A part that follows a level does not need to know which kind it is wired to.
//
//   number                 wire
//   0 .. kMaxPins - 1      the board's pin of that number
//   kMaxPins + 8 r + q     output q of the robot's register number r, in the file's order
//
// A shift register is one register, a PWM driver of 16 channels is two. Their outputs are named "REG1.Q0" to
// "REG1.Q7" and "pwm.0" to "pwm.15".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hal/board/robot_port.h"
#include "sim/base/snapshot_registry.h"

namespace robosim::robot {

constexpr int kRegisterOutputs = 8;  ///< of one register
constexpr int kMostRegisters = 16;   ///< of one robot

/// Eight outputs of a part.
struct Register {
  std::string part;
  int first_channel = -1;  ///< of a PWM driver: the number of its first output; else -1

  friend bool operator==(const Register&, const Register&) = default;
};

/// Returns the wire at output `q` of register number `index`; `q` may exceed one register, and continue in
/// the next.
constexpr Pin output_pin(int index, int q) {
  return static_cast<Pin>(kMaxPins + kRegisterOutputs * index + q);
}
constexpr bool is_output(Pin pin) { return pin >= kMaxPins && pin != kNoPin; }
/// Returns its name as robot files write it, "REG1.Q4"; `registers` are the robot's, in their order.
std::string output_name(const std::vector<Register>& registers, Pin output);
/// Returns the number of the part's first register; nothing if it has none.
std::optional<int> register_of(const std::vector<Register>& registers, const std::string& part);
static_assert(output_pin(kMostRegisters, 0) < kNoPin);

class Netlist {
 public:
  Netlist(RobotPort& board, std::size_t registers, SnapshotRegistry& snapshots)
      : board_(board), watchers_(registers * kRegisterOutputs) {
    state_.outputs.resize(watchers_.size());
    snapshots.add(state_);
  }

  /// How a wire is driven. A shift register's output that is switched off is not driven.
  const PinDrive& drive(Pin pin) const {
    return is_output(pin) ? state_.outputs[index_of(pin)] : board_.drive(pin);
  }
  /// Watches as RobotPort::watch() does.
  void watch(Pin pin, PinWatcher& watcher);
  /// For shift registers and PWM drivers: drives an output. Notifies watchers if it has changed.
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
