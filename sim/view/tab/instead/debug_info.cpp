// Replaces the reader of debug information, which needs libdw. Images in a tab have no debug information, so
// messages do not name lines of the sketch.
#include "sim/exec/elf/debug_info.h"

namespace robosim::exec {

DebugInfo::DebugInfo(const std::filesystem::path&) {}
DebugInfo::~DebugInfo() = default;

std::vector<SourceLine> DebugInfo::frames(std::uint32_t) const { return {}; }
const SourceLine& DebugInfo::place(std::uint32_t pc) const { return places_[pc]; }
const SourceLine& DebugInfo::sketch_place(std::uint32_t pc) const { return sketch_places_[pc]; }
DebugInfo::CodeOf DebugInfo::code_of(const std::string&) const { return {}; }
std::vector<DebugInfo::Entry> DebugInfo::entries_of(const std::string&) const { return {}; }
std::vector<DebugInfo::CodeLine> DebugInfo::lines() const { return {}; }
std::vector<DebugInfo::Number> DebugInfo::numbers() const { return {}; }
DebugInfo::Variable DebugInfo::variable_at(std::uint32_t) const { return {}; }

bool is_core_file(const std::string&) { return false; }

}  // namespace robosim::exec
