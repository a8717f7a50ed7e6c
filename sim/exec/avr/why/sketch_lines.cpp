#include "sim/exec/avr/why/sketch_lines.h"

#include <algorithm>
#include <iterator>

namespace robosim::exec::avr {
namespace {

/// Functions of the core that wait for the clock, or for room in a buffer, and return in any case.
constexpr const char* kPauses[] = {"delay", "micros",  "write",       "print",
                                   "flush", "println", "printNumber", "printFloat"};

}  // namespace

SketchLines::Line SketchLines::line(const SourceLine& where) const {
  return &lines_.try_emplace({where.file, where.line}, where).first->second;
}

const SketchLines::Place& SketchLines::at(std::uint32_t pc) const {
  const auto [known, fresh] = places_.try_emplace(pc);
  if (!fresh) return known->second;
  for (const SourceLine& frame : debug_.frames(2 * pc)) {
    known->second.is_described = true;
    if (!is_core_file(frame.file))
      known->second.lines.push_back(line(frame));
    else if (std::find(std::begin(kPauses), std::end(kPauses), frame.function) != std::end(kPauses))
      known->second.is_pause = true;
  }
  return known->second;
}

const std::vector<SketchLines::Line>& SketchLines::declarations(std::uint32_t address) const {
  const auto [known, fresh] = declarations_.try_emplace(address);
  if (!fresh) return known->second;
  const DebugInfo::Variable variable = debug_.variable_at(address);
  for (const SourceLine& where : {variable.where, variable.member})
    if (!where.file.empty() && !is_core_file(where.file)) known->second.push_back(line(where));
  return known->second;
}

}  // namespace robosim::exec::avr
