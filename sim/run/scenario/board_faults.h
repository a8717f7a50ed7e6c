// Simulates faults of the board's supply, serial line, EEPROM and clock. Scripts call these `power`,
// `serial`, `eeprom` and `clock`. A script can also break the robot's parts, which sim/robot simulates.
//
// - Power. The board's regulator gives the chip min(supply, battery - regulator_drop_volts). Below
//   brown_out_volts, the chip is held in reset; it restarts when the voltage rises again. The BoardSpec
//   contains both values. If even the healthy battery gives the chip less than brown_out_volts, or less than
//   kLogicKeeps, the board must have a supply other than this battery. In that case no sag resets the chip.
// - Serial. Loses, doubles or corrupts bytes on their way to the firmware. A hash of (seed, number of the
//   byte) selects the affected bytes.
// - EEPROM. Writing a byte takes kEepromWriteTime. After a power failure in that time, the byte may have any
//   value; the script selects the value. The fault `eeprom used` fills the EEPROM with bytes as if another
//   sketch had left them: each byte is a hash of (seed, address).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "hal/board/robot_port.h"
#include "sim/base/noise.h"
#include "sim/exec/core/executor.h"
#include "sim/judge/supply_summary.h"
#include "sim/result/events.h"
#include "sim/robot/robot.h"
#include "sim/run/scenario/scenario.h"

namespace robosim::scenario {

constexpr double kLogicKeeps = 2.0;  ///< V; below this supply, a 74HC595 loses its state
/// V; below this supply, an AVR is off. The value is the typical power-on reset threshold for a falling
/// supply; the range is 0.6 to 1.6 V (data sheet 8025I of the ATmega48P to 328P, table 26-3). RAM is assumed
/// to keep its content down to this voltage. The voltage that RAM needs is 50 mV in an ATmega164P (7674F,
/// 26.4); for an ATmega328P, no value was found.
constexpr double kPowerOnReset = 1.3;

/// The faults that a script can request, parsed and checked. A default-constructed fault represents the
/// script's word "ok", which ends a fault.
struct PowerFault {
  enum class Kind { none, sag, brown_out };
  Kind kind = Kind::none;
  double volts = 0.0;  ///< voltage of a sag
  bool repairs() const { return kind == Kind::none; }
};
struct SerialFault {
  enum class Kind { none, lost, doubled, corrupted };
  Kind kind = Kind::none;
  double share = 0.0;     ///< share of the affected bytes
  std::uint64_t nth = 0;  ///< number of the only affected byte, from 1; 0 = `share` decides
  bool repairs() const { return kind == Kind::none; }
};
/// A flipped bit. The word "ok" cannot end this fault.
struct EepromFlip {
  std::uint16_t address = 0;
  int bit = 0;
  bool repairs() const { return false; }
};
/// The bytes of another sketch. The word "ok" cannot end this fault.
struct EepromUsed {
  bool repairs() const { return false; }
};
struct ClockDrift {
  std::optional<int> ppm = {};  ///< amount by which the clock is too fast; empty = no fault
  bool repairs() const { return !ppm; }
};
using BoardFault = std::variant<PowerFault, SerialFault, EepromFlip, EepromUsed, ClockDrift>;
bool repairs(const BoardFault& fault);

class BoardFaults final : EepromWatcher {
 public:
  /// `number` is the robot's number in its world.
  BoardFaults(exec::Executor& executor, robot::Robot& robot, std::uint64_t seed, std::uint32_t number = 0);

  static bool knows(const std::string& name);
  static const std::vector<std::string>& names();

  /// Parses a fault. The first of the `arguments` is the fault's kind. `ends` states whether the script gives
  /// the fault a duration. Throws InputError.
  BoardFault read(const std::string& name, const std::vector<std::string>& arguments,
                  bool ends = false) const;
  /// Throws InputError if the firmware's EEPROM is inaccessible on this target.
  void check_eeprom() const;
  /// Starts a fault. The fault replaces an earlier fault of the same type, such as SerialFault.
  void fail(const BoardFault& fault, SimTime t);
  /// Ends a fault.
  void repair(const BoardFault& fault, SimTime t);

  /// Sets the battery's voltage. This may start or stop the chip.
  void feed(double volts, SimTime t);
  /// Operates the switch between battery and board. When the switch is off, parts that share the board's
  /// supply lose their state.
  void switch_power(bool on, SimTime t);
  /// Returns whether the chip runs: the board is switched on and the chip's voltage is high enough.
  bool powered() const { return state_.powered; }
  /// Returns the present and past state of the supply.
  judge::SupplySummary power() const;
  /// Interrupts the EEPROM write that is in progress at `t`: sets the byte to the value that `what` selects.
  /// Returns the byte's address and value, or nullopt if there is no write.
  std::optional<result::PowerLost::HalfWritten> leave_half_written(const HalfWritten& what, SimTime t);

  /// Sends bytes to the firmware.
  void send(const std::string& bytes, SimTime t);

  /// Returns how often the chip has started so far.
  std::uint64_t boots() const { return state_.boots; }
  /// Returns the number of EEPROM writes that the firmware has begun since the start of the run.
  std::uint64_t eeprom_writes() const { return state_.writes; }

  struct Write {
    std::uint16_t address;
    std::uint8_t before;
    SimTime began;
  };
  /// The state that changes during a run.
  struct State {
    bool switched_on = true;
    bool powered = true;
    SimTime changed = 0;       ///< when `powered` last changed
    int resets = 0;            ///< number of resets because of low voltage
    bool browned_out = false;  ///< the chip is off because of low voltage
    SimTime recovered = 0;     ///< when the chip last restarted after low voltage
    bool was_gone = false;  ///< the supply was off after the chip last ran, so the next start is a power-on
    std::uint64_t boots = 1;
    double chip_volts = 0.0;  ///< V, supply voltage of the chip
    bool keeps = true;        ///< parts on the board's supply retain their state
    SerialFault serial;
    std::uint64_t bytes = 0;         ///< number of bytes sent to the firmware so far
    std::uint64_t bytes_before = 0;  ///< value of `bytes` when the current serial fault began
    std::uint64_t writes = 0;
    std::optional<Write> last_write;
  };
  const State& save() const { return state_; }
  void restore(const State& saved) { state_ = saved; }

 private:
  void eeprom_written(std::uint16_t address, std::uint8_t before, std::uint8_t value, SimTime t) override;
  void set_battery(double volts, SimTime t);
  void supply_board(double volts, SimTime t);
  void update_power(SimTime t);
  void begin(const PowerFault& fault, SimTime t);
  void begin(const SerialFault& fault, SimTime t);
  void begin(const EepromFlip& fault, SimTime t);
  void begin(const EepromUsed& fault, SimTime t);
  void begin(const ClockDrift& fault, SimTime t);

  exec::Executor& executor_;
  robot::Robot& robot_;
  const NoiseStream noise_;
  const NoiseStream left_there_;  ///< draws the bytes that another sketch left in the EEPROM
  State state_;
};

}  // namespace robosim::scenario
