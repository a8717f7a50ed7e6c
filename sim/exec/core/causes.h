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

/// A line of the sketch that had its part in it.
struct CauseStep {
  enum class Kind : std::uint8_t {
    computes,  ///< it has computed a value, or stored it
    decides,   ///< it has decided that another line runs
    reads,     ///< it has looked at a pin
    asks_time,
    receives,  ///< a byte
    keeps,     ///< a variable, or a constant, that has what it began with; the line declares it
  };
  Kind kind = Kind::computes;
  wire::SourceLine where;
  SimTime t = 0;     ///< when it last did, by the world's clock
  int far = 0;       ///< how many lines lie between
  Pin pin = kNoPin;  ///< that it has looked at
};

class CauseFinder {
 public:
  virtual ~CauseFinder() = default;

  /// Forgets what was noted, and notes from now on. The chip is slower meanwhile.
  virtual void begin() = 0;
  virtual void end() = 0;

  /// Forgets what was asked, and asks why the chip drives these pins as it does at `t`, which is noted.
  virtual void ask(const std::vector<Pin>& pins, SimTime t) = 0;
  /// Why the firmware was at `t` where it was.
  virtual void ask_place(SimTime t) = 0;
  /// Back to the beginning of what is noted. `adjoins`: what was followed before began where this ends.
  virtual void follow(bool adjoins) = 0;
  /// Of data memory: what was made before, the nearest first.
  virtual std::vector<std::uint16_t> open_bytes() const = 0;
  /// These of them are followed no further.
  virtual void give_up(const std::vector<std::uint16_t>& bytes) = 0;
  /// Whether something is open that registers held.
  virtual bool open_registers() const = 0;
  /// As data memory is now.
  virtual std::uint8_t byte(std::uint16_t address) const = 0;
  /// Nothing lies further back: what is open has the value that the program began with.
  virtual void close() = 0;

  /// The nearest first.
  virtual std::vector<CauseStep> steps() const = 0;
  /// The line of the sketch that most of the time between was spent in, with what it called.
  virtual wire::SourceLine busiest(SimTime from, SimTime to) const = 0;

  struct Share {
    wire::SourceLine where;
    double of_all = 0;  ///< 0 to 1
  };
  /// What part of the time between the sketch's interrupt handlers took, and the line that took most of it.
  virtual Share handlers(SimTime from, SimTime to) const = 0;
  /// Whether interrupts may come now.
  virtual bool interrupts_on() const = 0;
  /// The last that has switched interrupts off in what is noted: a line, or the handler that began. `on`:
  /// whether they were on when it began.
  virtual std::optional<CauseStep> switched_off(bool on) = 0;
};

}  // namespace robosim::exec
