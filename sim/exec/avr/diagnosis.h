// What can be found out about firmware from its chip's state and its debug information.
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
  /// But for its last_call.
  Activity activity() const;
  SourceLine where_now() const;
  /// Of the instruction that is running, or the calls that led there: the sketch's own line, not a library's.
  SourceLine sketch_line() const;
  /// The first of these calls that is the user's.
  SourceLine place_of_calls(const std::vector<Stack::Call>& calls) const;

 private:
  SourceLine place_of_check(const Undefined& found) const;
  /// Where the jump at `pc` leads (`jmp`, `rjmp`); none of any other instruction.
  std::optional<std::uint32_t> jump_target(std::uint32_t pc) const;
  /// The interrupt whose vector leads to address 0 at once, as avr-libc's for interrupts without a handler.
  std::optional<int> unhandled(const Fault& fault) const;
  std::string jump_text(const Fault& fault) const;
  std::string overflow_text() const;
  std::string reason(const Fault& fault) const;
  std::string api_call(std::uint32_t pc) const;
  /// The core's function that the sketch has called and is in: "delay()", not what delay() calls. Empty if it
  /// is in none.
  std::string api_call_now() const;
  std::string stopped_by() const;
  std::vector<SourceLine> call_chain(std::uint32_t pc) const;
  std::string registers() const;

  const Firmware& firmware_;
  const DebugInfo& debug_;
  const Machine& machine_;
};

}  // namespace robosim::exec::avr
