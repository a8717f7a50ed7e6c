// Derives facts about firmware from its chip's state and its debug information.
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
  /// Returns the innermost line of the call stack that is in the sketch, not in a library. Without one,
  /// returns where_now().
  SourceLine sketch_line() const;
  /// Returns the place of the first of `calls` that is in user code.
  SourceLine place_of_calls(const std::vector<Stack::Call>& calls) const;

 private:
  SourceLine place_of_check(const Undefined& found) const;
  /// Returns the target of the jump at `pc` (`jmp`, `rjmp`); nothing for any other instruction.
  std::optional<std::uint32_t> jump_target(std::uint32_t pc) const;
  /// Returns the interrupt whose vector leads directly to address 0. avr-libc generates such vectors for
  /// interrupts without a handler.
  std::optional<int> unhandled(const Fault& fault) const;
  std::string jump_text(const Fault& fault) const;
  std::string overflow_text() const;
  std::string reason(const Fault& fault) const;
  std::string api_call(std::uint32_t pc) const;
  /// Returns the core's function that the sketch has called and that is still running: "delay()", not a
  /// function that delay() calls. Empty if there is no such function.
  std::string api_call_now() const;
  std::string stopped_by() const;
  std::vector<SourceLine> call_chain(std::uint32_t pc) const;
  std::string registers() const;

  const Firmware& firmware_;
  const DebugInfo& debug_;
  const Machine& machine_;
};

}  // namespace robosim::exec::avr
