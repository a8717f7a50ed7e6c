// Derives the firmware's crash report, activity and source lines from the chip's state and debug information.
#pragma once

#include "sim/exec/avr/machine.h"
#include "sim/exec/elf/debug_info.h"
#include "sim/exec/host/undefined.h"

namespace robosim::exec::avr {

class Diagnosis {
 public:
  Diagnosis(const Firmware& firmware, const DebugInfo& debug, const Machine& machine)
      : firmware_(firmware), debug_(debug), machine_(machine) {}

  Crash crash(const Fault& fault) const;
  /// Returns the current activity, except last_call.
  Activity activity() const;
  SourceLine where_now() const;
  /// Returns the innermost line on the call stack that belongs to the sketch itself, not to a library. If no
  /// line does, returns where_now().
  SourceLine sketch_line() const;
  /// Returns the source line of the first of `calls` that is in user code.
  SourceLine place_of_calls(const std::vector<Stack::Call>& calls) const;

 private:
  SourceLine place_of_check(const Undefined& found) const;
  /// Returns the target of the jump at `pc` (`jmp`, `rjmp`); nullopt for any other instruction.
  std::optional<std::uint32_t> jump_target(std::uint32_t pc) const;
  /// Returns the interrupt that caused the fault because it has no handler; nullopt for other faults. In
  /// avr-libc, the vector of an interrupt without a handler jumps to address 0.
  std::optional<int> unhandled(const Fault& fault) const;
  std::string jump_text(const Fault& fault) const;
  std::string overflow_text() const;
  std::string reason(const Fault& fault) const;
  std::string api_call(std::uint32_t pc) const;
  /// Returns the Arduino function that the sketch is calling: "delay()", not a function that delay() calls.
  /// Returns an empty text if the sketch runs its own code.
  std::string api_call_now() const;
  std::string stopped_by() const;
  std::vector<SourceLine> call_chain(std::uint32_t pc) const;
  std::string registers() const;

  const Firmware& firmware_;
  const DebugInfo& debug_;
  const Machine& machine_;
};

}  // namespace robosim::exec::avr
