// Finds the causes of firmware's actions. Follows a value back through the instructions that computed it, to
// the inputs that were read.
//
//   begin()         records each instruction from now on
//   ask()           selects the question: why pins are driven, or (ask_place()) why firmware is at its place
//   follow()        goes back to the beginning of the record
//   open_bytes()    returns the bytes that were written before the record. To trace them, restore an earlier
//                   state, call begin(), run again, and call follow() again
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
    computes,  ///< computed a value, or stored it
    decides,   ///< decided that another line runs
    reads,     ///< read a pin
    asks_time,
    receives,  ///< received a byte
    keeps,     ///< declares a variable or constant that still has its initial value
  };
  Kind kind = Kind::computes;
  result::SourceLine where;
  SimTime t = 0;     ///< time of its last contribution, by the world's clock
  int far = 0;       ///< number of lines between this one and the effect
  Pin pin = kNoPin;  ///< pin that was read
};

class CauseFinder {
 public:
  virtual ~CauseFinder() = default;

  /// Drops the record and starts a new one. The chip runs more slowly while recording.
  virtual void begin() = 0;
  virtual void end() = 0;

  /// Starts a new search for the reason why the chip drives these pins as it does at `t`. The record must
  /// include `t`.
  virtual void ask(const std::vector<Pin>& pins, SimTime t) = 0;
  /// Starts a new search for the reason why the firmware was at its place at `t`.
  virtual void ask_place(SimTime t) = 0;
  /// Follows values back to the beginning of the record. `adjoins`: the record ends where the previously
  /// followed record begins.
  virtual void follow(bool adjoins) = 0;
  /// Returns the addresses of followed bytes that were written before the record, the nearest first.
  virtual std::vector<std::uint16_t> open_bytes() const = 0;
  /// Stops following these bytes.
  virtual void give_up(const std::vector<std::uint16_t>& bytes) = 0;
  /// Returns whether a value in a register has not been traced yet.
  virtual bool open_registers() const = 0;
  /// Returns the present value of a byte of data memory.
  virtual std::uint8_t byte(std::uint16_t address) const = 0;
  /// Ends the search. All values that are still followed count as unchanged since the program's start.
  virtual void close() = 0;

  /// Returns the steps, the nearest first.
  virtual std::vector<CauseStep> steps() const = 0;
  /// Returns the line of the sketch that took most of the time from `from` to `to`, including its calls.
  virtual result::SourceLine busiest(SimTime from, SimTime to) const = 0;

  struct Share {
    result::SourceLine where;
    double of_all = 0;  ///< 0 to 1
  };
  /// Returns the share of time that the sketch's interrupt handlers took, and the line that took most of that
  /// time.
  virtual Share handlers(SimTime from, SimTime to) const = 0;
  /// Returns whether interrupts are enabled now.
  virtual bool interrupts_on() const = 0;
  /// Returns the last place in the record that disabled interrupts: a line, or the handler that began. `on`:
  /// whether interrupts were enabled when the record began.
  virtual std::optional<CauseStep> switched_off(bool on) = 0;
};

}  // namespace robosim::exec
