// Finds the causes of what firmware did: follows a value back through the instructions that computed it, to
// the inputs that were read.
//
//   begin()         records each instruction from now on
//   ask()           asks what drives these pins, or why firmware is where it is
//   follow()        goes back through everything recorded, to its beginning
//   open_bytes()    returns the bytes that were written earlier: restore an earlier moment, call begin()
//                   there, run on, and call follow() again
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hal/board/board.h"
#include "sim/wire/run_result.h"

namespace robosim::exec {

/// A line of the sketch that contributed to an effect.
struct CauseStep {
  enum class Kind : std::uint8_t {
    computes,  ///< it computed a value, or stored it
    decides,   ///< it decided that another line runs
    reads,     ///< it read a pin
    asks_time,
    receives,  ///< it received a byte
    keeps,     ///< it declares a variable or constant that still has its initial value
  };
  Kind kind = Kind::computes;
  wire::SourceLine where;
  SimTime t = 0;     ///< when it last did so, by the world's clock
  int far = 0;       ///< number of lines in between
  Pin pin = kNoPin;  ///< the pin that it read
};

class CauseFinder {
 public:
  virtual ~CauseFinder() = default;

  /// Drops the record, and starts a new one. The chip is slower while recording.
  virtual void begin() = 0;
  virtual void end() = 0;

  /// Drops the previous question, and asks why the chip drives these pins as it does at `t`, which is
  /// recorded.
  virtual void ask(const std::vector<Pin>& pins, SimTime t) = 0;
  /// Asks why the firmware was at its place at `t`.
  virtual void ask_place(SimTime t) = 0;
  /// Follows back to the beginning of the record. `adjoins`: the record ends where the one followed before
  /// begins.
  virtual void follow(bool adjoins) = 0;
  /// Returns the addresses of data memory that were written before the record, the nearest first.
  virtual std::vector<std::uint16_t> open_bytes() const = 0;
  /// Stops following these bytes.
  virtual void give_up(const std::vector<std::uint16_t>& bytes) = 0;
  /// Returns whether a value in a register is not traced yet.
  virtual bool open_registers() const = 0;
  /// Returns a byte of data memory as it is now.
  virtual std::uint8_t byte(std::uint16_t address) const = 0;
  /// Ends the search: everything that is still open has its value from the program's start.
  virtual void close() = 0;

  /// Returns the steps, the nearest first.
  virtual std::vector<CauseStep> steps() const = 0;
  /// Returns the line of the sketch that took most of the time in between, including what it called.
  virtual wire::SourceLine busiest(SimTime from, SimTime to) const = 0;

  struct Share {
    wire::SourceLine where;
    double of_all = 0;  ///< 0 to 1
  };
  /// Returns the share of time that the sketch's interrupt handlers took, and the line that took most of it.
  virtual Share handlers(SimTime from, SimTime to) const = 0;
  /// Returns whether interrupts are enabled.
  virtual bool interrupts_on() const = 0;
  /// Returns the last place in the record that disabled interrupts: a line, or the handler that began. `on`:
  /// whether interrupts were enabled when the record began.
  virtual std::optional<CauseStep> switched_off(bool on) = 0;
};

}  // namespace robosim::exec
