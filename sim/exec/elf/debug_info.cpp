#include "sim/exec/elf/debug_info.h"

#include <dwarf.h>
#include <elfutils/libdw.h>
#include <fcntl.h>
#include <unistd.h>

namespace robosim::exec {
namespace {

std::string name_of(Dwarf_Die& die) {
  const char* name = dwarf_diename(&die);
  return name ? name : "";
}

std::string tidy(const char* file) {
  std::string name = file ? file : "";
  if (name.starts_with("./")) name.erase(0, 2);
  return name;
}

/// Calls `visit` for every compilation unit.
template <typename Visit>
void for_each_unit(Dwarf* dwarf, Visit visit) {
  Dwarf_Off offset = 0, next = 0;
  std::size_t header = 0;
  while (dwarf_nextcu(dwarf, offset, &next, &header, nullptr, nullptr, nullptr) == 0) {
    Dwarf_Die unit;
    if (dwarf_offdie(dwarf, offset + header, &unit)) visit(unit);
    offset = next;
  }
}

bool is_code(Dwarf_Die& die) {
  const int tag = dwarf_tag(&die);
  return tag == DW_TAG_subprogram || tag == DW_TAG_inlined_subroutine;
}

/// From the unit down to the innermost function that holds `pc`.
void find_scopes(Dwarf_Die parent, Dwarf_Addr pc, std::vector<Dwarf_Die>& scopes) {
  Dwarf_Die child;
  if (dwarf_child(&parent, &child) != 0) return;
  do {
    const int tag = dwarf_tag(&child);
    if (is_code(child)) {
      if (dwarf_haspc(&child, pc) != 1) continue;
      scopes.push_back(child);
      find_scopes(child, pc, scopes);
      return;
    }
    if (tag == DW_TAG_lexical_block && dwarf_haspc(&child, pc) == 1) {
      const std::size_t before = scopes.size();
      find_scopes(child, pc, scopes);
      if (scopes.size() > before) return;
    }
  } while (dwarf_siblingof(&child, &child) == 0);
}

void find_entries(Dwarf_Die parent, const std::string& function, std::vector<Dwarf_Addr>& entries) {
  Dwarf_Die child;
  if (dwarf_child(&parent, &child) != 0) return;
  do {
    Dwarf_Addr entry = 0;
    if (is_code(child) && name_of(child) == function && dwarf_entrypc(&child, &entry) == 0)
      entries.push_back(entry);
    find_entries(child, function, entries);
  } while (dwarf_siblingof(&child, &child) == 0);
}

/// Where a function was inlined: file and line of the call.
SourceLine call_of(Dwarf_Die& unit, Dwarf_Die& inlined) {
  SourceLine place;
  Dwarf_Attribute attribute;
  Dwarf_Word value = 0;
  if (dwarf_attr(&inlined, DW_AT_call_line, &attribute) && dwarf_formudata(&attribute, &value) == 0)
    place.line = static_cast<int>(value);
  Dwarf_Files* files = nullptr;
  std::size_t count = 0;
  if (dwarf_attr(&inlined, DW_AT_call_file, &attribute) && dwarf_formudata(&attribute, &value) == 0 &&
      dwarf_getsrcfiles(&unit, &files, &count) == 0 && value < count)
    place.file = tidy(dwarf_filesrc(files, value, nullptr, nullptr));
  return place;
}

}  // namespace

bool is_core_file(const std::string& file) {
  return file.empty() || file[0] == '?' || file[0] == '<' || file.starts_with("arduino/") ||
         file.starts_with("robosim/") || file.find("/arduino/") != std::string::npos ||
         file.starts_with("/usr/") || file.starts_with("../");  // of newlib and libgcc
}

DebugInfo::DebugInfo(const std::filesystem::path& file)
    : descriptor_(::open(file.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (descriptor_ >= 0) dwarf_ = dwarf_begin(descriptor_, DWARF_C_READ);
}

DebugInfo::~DebugInfo() {
  if (dwarf_) dwarf_end(dwarf_);
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::vector<SourceLine> DebugInfo::frames(std::uint32_t pc) const {
  std::vector<SourceLine> frames;
  if (!dwarf_) return frames;
  for_each_unit(dwarf_, [&](Dwarf_Die unit) {
    if (!frames.empty()) return;
    std::vector<Dwarf_Die> scopes;
    find_scopes(unit, pc, scopes);
    if (scopes.empty()) return;
    SourceLine at;
    if (Dwarf_Line* line = dwarf_getsrc_die(&unit, pc)) {
      dwarf_lineno(line, &at.line);
      at.file = tidy(dwarf_linesrc(line, nullptr, nullptr));
    }
    for (std::size_t i = scopes.size(); i-- > 0;) {
      at.function = name_of(scopes[i]);
      frames.push_back(at);
      at = call_of(unit, scopes[i]);
    }
  });
  return frames;
}

std::optional<std::uint32_t> DebugInfo::entry_of(const std::string& function) const {
  std::vector<Dwarf_Addr> entries;
  if (dwarf_) for_each_unit(dwarf_, [&](Dwarf_Die unit) { find_entries(unit, function, entries); });
  if (entries.size() != 1) return std::nullopt;
  return static_cast<std::uint32_t>(entries[0]);
}

}  // namespace robosim::exec
