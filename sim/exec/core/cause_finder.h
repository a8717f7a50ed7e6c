// Finds the causes of the firmware's actions. Follows a value back through the instructions that computed the
// value, to the inputs that the firmware read.
//
//   begin()         starts to record each instruction
//   ask()           starts a search for the reason why the chip drives certain pins, or sent certain bytes
//   ask_place()     starts a search for the reason why the firmware was at a certain line
//   follow()        follows the values of the search back to the beginning of the record
//   open_bytes()    returns the followed bytes that were written before the record began. To trace these
//                   bytes, restore an earlier state, call begin(), run again, and call follow() again
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hal/board/board.h"
#include "sim/result/run_result.h"

namespace robosim::exec {

/// A line of the sketch that contributed to an effect.
struct CauseStep {
  enum class Kind : std::uint8_t {
    computes,  ///< computed a value, or stored a value
    decides,   ///< decided that another line ran
    reads,     ///< read a pin
    asks_time,
    receives,  ///< received a byte
    keeps,     ///< declares a variable or constant that still has its initial value
  };
  Kind kind = Kind::computes;
  result::SourceLine where;
  SimTime t = 0;     ///< time of the line's last contribution, by the world's clock
  int far = 0;       ///< distance from the effect, in lines
  Pin pin = kNoPin;  ///< pin that was read
};

class CauseFinder {
 public:
  /// An effect of the firmware on the board.
  struct Effect {
    std::vector<Pin> pins;        ///< pins that the chip drives
    bool sends_two_wire = false;  ///< also the bytes that the chip sent as two-wire master
  };

  virtual ~CauseFinder() = default;

  /// Drops the record and starts a new one. The chip runs more slowly while recording. If the chip loses its
  /// power, the record starts again at power-on.
  virtual void begin() = 0;
  virtual void end() = 0;

  /// Starts a new search for the causes of an effect at `t`: the pins' states at `t`, and the bytes that were
  /// sent between the beginning of the record and `t`. The record must include `t`.
  virtual void ask(const Effect& effect, SimTime t) = 0;
  /// Starts a new search for the reason why the firmware ran the line that was running at `t`.
  virtual void ask_place(SimTime t) = 0;
  /// Follows values back to the beginning of the record. `adjoins` is true if the record ends where the
  /// record of the previous follow() begins.
  virtual void follow(bool adjoins) = 0;
  /// Returns the addresses of followed bytes that were written before the record began. The bytes that are
  /// nearest to the effect come first.
  virtual std::vector<std::uint16_t> open_bytes() const = 0;
  /// Stops following these bytes.
  virtual void give_up(const std::vector<std::uint16_t>& bytes) = 0;
  /// Returns whether a followed value was in a register when the record began.
  virtual bool open_registers() const = 0;
  /// Returns the present value of the byte at an address of data memory; nullopt if the chip has no power.
  virtual std::optional<std::uint8_t> byte(std::uint16_t address) const = 0;
  /// Ends the search. All bytes that are still followed count as unchanged since the program's start.
  /// Therefore the declarations of these bytes become steps.
  virtual void close() = 0;

  /// Returns the steps. The steps that are nearest to the effect come first.
  virtual std::vector<CauseStep> steps() const = 0;
  /// Returns the line of the sketch that took most of the time from `from` to `to`. The time of a line
  /// includes the functions of the core that the line calls.
  virtual result::SourceLine busiest(SimTime from, SimTime to) const = 0;

  struct Share {
    result::SourceLine where;
    double of_all = 0;  ///< share of all time, 0 to 1
  };
  /// Returns the share of time that the sketch's interrupt handlers took. Also returns the line in a
  /// handler that took most of this time. The time of a line includes the functions that the line calls.
  virtual Share handlers(SimTime from, SimTime to) const = 0;
  /// Returns whether interrupts are enabled now.
  virtual bool interrupts_on() const = 0;
  /// Returns the last step in the record that disabled interrupts: a line of the sketch, or the start of a
  /// handler. `on` is true if interrupts were enabled when the record began.
  virtual std::optional<CauseStep> switched_off(bool on) = 0;
};

}  // namespace robosim::exec
