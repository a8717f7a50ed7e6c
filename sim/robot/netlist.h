// The wires between the microcontroller and the parts: the board's pins, and the outputs of the robot's shift
// registers and PWM drivers. A part that only follows a level, such as an LED, may use either kind of wire.
//
//   number                 wire
//   0 .. kMaxPins - 1      the board's pin of that number
//   kMaxPins + 8 r + q     output q of the robot's register number r, in the file's order
//
// A shift register counts as one register, and a PWM driver of 16 channels as two. Their outputs are named
// "REG1.Q0" to "REG1.Q7" and "pwm.0" to "pwm.15".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hal/board/robot_port.h"
#include "sim/base/snapshot_registry.h"

namespace robosim::robot {

constexpr int kRegisterOutputs = 8;  ///< number of outputs of one register
constexpr int kMostRegisters = 16;   ///< maximum number of registers of one robot

/// Eight outputs of a part: a shift register, or half of a PWM driver.
struct Register {
  std::string part;
  int first_channel = -1;  ///< of half a PWM driver: the channel of its first output; -1 = shift register

  friend bool operator==(const Register&, const Register&) = default;
};

/// Returns the wire at output `q` of register number `index`. A `q` of 8 or more refers to the registers that
/// follow.
constexpr Pin output_pin(int index, int q) {
  return static_cast<Pin>(kMaxPins + kRegisterOutputs * index + q);
}
constexpr bool is_output(Pin pin) { return pin >= kMaxPins && pin != kNoPin; }
/// Returns an output's name in robot files, such as "REG1.Q4". `registers` are the robot's registers, in
/// order.
std::string output_name(const std::vector<Register>& registers, Pin output);
/// Returns the number of a part's first register; nullopt if the part has none.
std::optional<int> register_of(const std::vector<Register>& registers, const std::string& part);
static_assert(output_pin(kMostRegisters, 0) < kNoPin);

class Netlist {
 public:
  Netlist(RobotPort& board, std::size_t registers, SnapshotRegistry& snapshots)
      : board_(board), watchers_(registers * kRegisterOutputs) {
    state_.outputs.resize(watchers_.size());
    snapshots.add(state_);
  }

  /// Returns the drive of a wire. A shift register that is switched off does not drive its outputs.
  const PinDrive& drive(Pin pin) const {
    return is_output(pin) ? state_.outputs[index_of(pin)] : board_.drive(pin);
  }
  /// Watches a wire, like RobotPort::watch().
  void watch(Pin pin, PinWatcher& watcher);
  /// Drives an output of a shift register or PWM driver. Notifies the watchers if the drive has changed.
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
