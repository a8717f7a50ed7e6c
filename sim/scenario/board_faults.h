// Faults between the board and the world around it. Scripts name them power, serial, eeprom and clock, in
// addition to the robot's parts.
//
// - Power. The board's regulator gives the chip min(supply, battery - regulator_drop_volts). Below
//   brown_out_volts (both of its BoardSpec) the chip is held in reset, and restarts when the voltage rises
//   again. A robot whose healthy battery gives less than that, or than kLogicKeeps, must have another supply
//   for its board, so no sag resets it.
// - Serial. Bytes on their way to the firmware, each byte independently, by a hash of (seed, its number).
// - EEPROM. Writing a byte takes kEepromWriteTime. If the power fails meanwhile, the byte may hold anything:
//   the script says what. A used chip holds what another sketch has left there: each byte by a hash of (seed,
//   its address).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "hal/board/robot_port.h"
#include "sim/base/noise.h"
#include "sim/exec/core/executor.h"
#include "sim/judge/power.h"
#include "sim/robot/robot.h"
#include "sim/scenario/scenario.h"
#include "sim/wire/events.h"

namespace robosim::scenario {

constexpr double kLogicKeeps = 2.0;  ///< V: less than that, and a 74HC's registers forget
/// V: less, and an AVR takes its supply for gone: V POT, falling, typical; 0.6 to 1.6 V (data sheet 8025I of
/// the ATmega48P to 328P, table 26-3). That RAM holds until then is an assumption: of an ATmega328P no figure
/// was found, of an ATmega164P it is 50 mV (7674F, 26.4, "RAM retention voltage").
constexpr double kPowerOnReset = 1.3;

/// The faults that a script can ask for, read and checked. As they are made by default, nothing is wrong: the
/// script's "ok".
struct PowerFault {
  enum class Kind { none, sag, brown_out };
  Kind kind = Kind::none;
  double volts = 0.0;  ///< of a sag
  bool repairs() const { return kind == Kind::none; }
};
struct SerialFault {
  enum class Kind { none, lost, doubled, corrupted };
  Kind kind = Kind::none;
  double share = 0.0;     ///< of the bytes
  std::uint64_t nth = 0;  ///< only this one, from 1; 0 = by share
  bool repairs() const { return kind == Kind::none; }
};
/// Has no "ok".
struct EepromFlip {
  std::uint16_t address = 0;
  int bit = 0;
  bool repairs() const { return false; }
};
/// Its bytes are those of another sketch. Has no "ok".
struct EepromUsed {
  bool repairs() const { return false; }
};
struct ClockDrift {
  std::optional<int> ppm = {};  ///< too fast
  bool repairs() const { return !ppm; }
};
using BoardFault = std::variant<PowerFault, SerialFault, EepromFlip, EepromUsed, ClockDrift>;
bool repairs(const BoardFault& fault);

class BoardFaults final : EepromWatcher {
 public:
  /// `number` is the robot's in its world.
  BoardFaults(exec::Executor& executor, robot::Robot& robot, std::uint64_t seed, std::uint32_t number = 0);

  static bool knows(const std::string& name);
  static const std::vector<std::string>& names();

  /// `arguments` begin with the kind. `ends`: whether it is to last for a time. Throws InputError.
  BoardFault read(const std::string& name, const std::vector<std::string>& arguments,
                  bool ends = false) const;
  /// Throws InputError where the firmware's EEPROM is out of reach on this target.
  void check_eeprom() const;
  /// A new fault of a thing replaces the one before.
  void fail(const BoardFault& fault, SimTime t);
  /// What has this fault is whole again.
  void repair(const BoardFault& fault, SimTime t);

  /// The battery gives so much now. Whether the chip runs may change by it.
  void feed(double volts, SimTime t);
  /// The switch between battery and board. Parts that share the board's supply lose their state.
  void switch_power(bool on, SimTime t);
  /// Whether the chip runs: it is switched on and has its voltage.
  bool powered() const { return state_.powered; }
  /// How the supply is and was.
  judge::Power power() const;
  /// Settles what the byte holds that is being written at `t`; nothing if none is.
  std::optional<wire::PowerLost::HalfWritten> leave_half_written(const HalfWritten& what, SimTime t);

  /// Bytes on their way to the firmware.
  void send(const std::string& bytes, SimTime t);

  /// How often the chip has started.
  std::uint64_t boots() const { return state_.boots; }
  /// By the firmware, since the run began.
  std::uint64_t eeprom_writes() const { return state_.writes; }

  struct Write {
    std::uint16_t address;
    std::uint8_t before;
    SimTime began;
  };
  /// What changes during a run.
  struct State {
    bool switched_on = true;
    bool powered = true;
    SimTime changed = 0;    ///< when `powered` last did
    int resets = 0;         ///< for want of voltage
    bool was_gone = false;  ///< the supply, since the chip last ran: not a brown-out, but power-on
    std::uint64_t boots = 1;
    double chip_volts = 0.0;  ///< of its supply
    bool keeps = true;        ///< parts on the board's supply have enough of it
    SerialFault serial;
    std::uint64_t bytes = 0;         ///< sent to the firmware so far
    std::uint64_t bytes_before = 0;  ///< before the present serial fault
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
  const NoiseStream left_there_;  ///< by another sketch, in the EEPROM
  State state_;
};

}  // namespace robosim::scenario
