// Derives the firmware's crash report, activity and source lines from the chip's state and debug information.
#pragma once

#include "sim/exec/elf/debug_info.h"
#include "sim/exec/stm32/machine.h"

namespace robosim::exec::stm32 {

class Diagnosis {
 public:
  Diagnosis(const Firmware& firmware, const DebugInfo& debug, const Machine& machine)
      : firmware_(firmware), debug_(debug), machine_(machine), cpu_(machine.cpu()) {}

  Crash crash(const Fault& fault) const;
  /// Returns the firmware's activity, except last_call.
  Activity activity() const;
  SourceLine where_now() const;
  /// Returns the source line of the first of `calls` that is in user code.
  SourceLine place_of(const std::vector<std::uint32_t>& calls) const;

 private:
  std::string access_text(const char* kind, std::uint32_t address) const;
  std::string jump_text(const Fault& fault) const;
  std::string reason(const Fault& fault) const;
  std::string api_call(std::uint32_t pc) const;
  std::string stopped_by() const;
  std::vector<SourceLine> call_chain(std::uint32_t pc) const;
  std::string registers() const;

  const Firmware& firmware_;
  const DebugInfo& debug_;
  const Machine& machine_;
  const Cpu& cpu_;
};

}  // namespace robosim::exec::stm32
