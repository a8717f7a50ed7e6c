#include "sim/exec/elf/loop_locator.h"

#include <algorithm>

namespace robosim::exec {

LoopMarks locate_loop(const ChipCode& code, const Symbols& symbols, const DebugInfo& debug) {
  const DebugInfo::CodeOf loop = debug.code_of("loop");
  if (!loop.inlined.empty()) {
    const Symbol* const into = symbols.function_at(loop.inlined[0].begin);
    if (!into || into->size == 0) return {};
    const auto inside = [&](std::uint32_t pc) {
      return std::any_of(loop.inlined.begin(), loop.inlined.end(),
                         [&](const DebugInfo::Range& range) { return pc >= range.begin && pc < range.end; });
    };
    return loop_marks_of(code.steps_of(*into), into->address, inside, nullptr);
  }
  const Symbol* const itself =
      loop.itself.empty() ? symbols.find("loop") : symbols.function_at(loop.itself[0].begin);
  if (itself && itself->code) {
    const std::vector<std::uint32_t> calls = code.calls_of(*itself);
    return {calls, calls};
  }
  const DebugInfo::CodeOf setup = debug.code_of("setup");
  if (!setup.itself.empty() || !setup.inlined.empty() || symbols.find("setup")) return {};
  const Symbol* const main = symbols.find("main");
  if (!main || !main->code || main->size == 0) return {};
  const auto line = [&](std::uint32_t pc) {
    const std::vector<SourceLine> frames = debug.frames(pc);
    return frames.empty() ? 0 : frames.back().line;
  };
  return loop_marks_of(code.steps_of(*main), main->address, nullptr, line);
}

}  // namespace robosim::exec
