#include "sim/exec/elf/debug_info.h"

#include <dwarf.h>
#include <elfutils/libdw.h>
#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <set>
#include <string_view>
#include <utility>

#include "sim/base/file.h"
#include "sim/exec/elf/demangle.h"

namespace robosim::exec {
namespace {

// Limits of nested scopes, rows of line tables, and name lengths. They end the search in damaged files.
// Compiled programs stay far below these limits.
constexpr int kDeepest = 256;
constexpr std::size_t kMostRows = 300'000, kLongestName = 1000;

std::string name_of(Dwarf_Die& die) {
  const char* name = dwarf_diename(&die);
  return name ? name : "";
}

std::string tidy(const char* file) {
  std::string name = file ? std::string(file, strnlen(file, kLongestName)) : "";
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

/// Collects the functions and inlined functions that contain `pc`, from the outermost to the innermost.
void find_scopes(Dwarf_Die parent, Dwarf_Addr pc, std::vector<Dwarf_Die>& scopes, int depth = 0) {
  Dwarf_Die child;
  if (depth > kDeepest || dwarf_child(&parent, &child) != 0) return;
  do {
    const int tag = dwarf_tag(&child);
    if (is_code(child)) {
      if (dwarf_haspc(&child, pc) != 1) continue;
      scopes.push_back(child);
      find_scopes(child, pc, scopes, depth + 1);
      return;
    }
    if (tag == DW_TAG_lexical_block && dwarf_haspc(&child, pc) == 1) {
      const std::size_t before = scopes.size();
      find_scopes(child, pc, scopes, depth + 1);
      if (scopes.size() > before) return;
    }
  } while (dwarf_siblingof(&child, &child) == 0);
}

bool is_free_function(Dwarf_Die& die, const std::string& name) {
  if (name_of(die) != name) return false;
  Dwarf_Attribute attribute;
  if (!dwarf_attr_integrate(&die, DW_AT_linkage_name, &attribute)) return true;
  const char* const linkage = dwarf_formstring(&attribute);
  return linkage && (linkage == name || linkage == fmt::format("_Z{}{}v", name.size(), name));
}

void find_code(Dwarf_Die parent, const std::string& function, DebugInfo::CodeOf& code, int depth = 0) {
  Dwarf_Die child;
  if (depth > kDeepest || dwarf_child(&parent, &child) != 0) return;
  do {
    if (is_code(child) && is_free_function(child, function)) {
      auto& ranges = dwarf_tag(&child) == DW_TAG_subprogram ? code.itself : code.inlined;
      Dwarf_Addr base = 0, begin = 0, end = 0;
      for (std::ptrdiff_t next = 0; (next = dwarf_ranges(&child, next, &base, &begin, &end)) > 0;)
        ranges.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)});
    }
    find_code(child, function, code, depth + 1);
  } while (dwarf_siblingof(&child, &child) == 0);
}

/// Returns the file and line of the call that the compiler has inlined.
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

/// Adds the statements of a unit's line table.
void add_rows(Dwarf_Die& unit, std::vector<DebugInfo::CodeLine>& lines) {
  Dwarf_Lines* rows = nullptr;
  std::size_t count = 0;
  if (dwarf_getsrclines(&unit, &rows, &count) != 0) return;
  bool first = true, left_out = false;
  for (std::size_t i = 0; i < count && lines.size() < kMostRows; ++i) {
    Dwarf_Line* const row = dwarf_onesrcline(rows, i);
    Dwarf_Addr address = 0;
    bool ends = false, begins = false;
    dwarf_lineaddr(row, &address);
    dwarf_lineendsequence(row, &ends);
    // Skips code that the linker has dropped. Its line table begins at address 0.
    if (std::exchange(first, ends)) left_out = address == 0;
    if (ends || left_out || dwarf_linebeginstatement(row, &begins) != 0 || !begins) continue;
    DebugInfo::CodeLine line{static_cast<std::uint32_t>(address), tidy(dwarf_linesrc(row, nullptr, nullptr))};
    dwarf_lineno(row, &line.line);
    lines.push_back(std::move(line));
  }
}

/// Adds the lines of calls that were inlined. Such a line may have no other code.
void add_calls(Dwarf_Die& unit, Dwarf_Die parent, std::vector<DebugInfo::CodeLine>& lines, int depth = 0) {
  Dwarf_Die child;
  if (depth > kDeepest || lines.size() >= kMostRows || dwarf_child(&parent, &child) != 0) return;
  do {
    Dwarf_Addr base = 0, begin = 0, end = 0;
    const bool inlined = dwarf_tag(&child) == DW_TAG_inlined_subroutine;
    if (inlined && (dwarf_entrypc(&child, &begin) == 0 || dwarf_ranges(&child, 0, &base, &begin, &end) > 0) &&
        begin != 0) {
      const SourceLine call = call_of(unit, child);
      lines.push_back({static_cast<std::uint32_t>(begin), call.file, call.line});
    }
    add_calls(unit, child, lines, depth + 1);
  } while (dwarf_siblingof(&child, &child) == 0);
}

/// Returns whether a part of the debug information is in other files. If so, the caller must use no debug
/// information, because libdw would open any file that the image names (DW_AT_dwo_name, .gnu_debugaltlink).
/// The image could name a pipe or another user's file.
bool names_other_files(Elf* elf, Dwarf* dwarf) {
  std::size_t names = 0;
  if (::elf_getshdrstrndx(elf, &names) != 0) return true;
  for (Elf_Scn* section = ::elf_nextscn(elf, nullptr); section; section = ::elf_nextscn(elf, section)) {
    GElf_Shdr header;
    const char* const name =
        ::gelf_getshdr(section, &header) ? ::elf_strptr(elf, names, header.sh_name) : nullptr;
    if (name && std::string_view(name) == ".gnu_debugaltlink") return true;
  }
  Dwarf_CU* unit = nullptr;
  std::uint8_t kind = 0;
  while (dwarf_get_units(dwarf, unit, &unit, nullptr, &kind, nullptr, nullptr) == 0)
    if (kind == DW_UT_skeleton) return true;
  return false;
}

}  // namespace

bool is_core_file(const std::string& file) {
  return file.empty() || file[0] == '?' || file[0] == '<' || file.starts_with("arduino/") ||
         file.starts_with("robosim/") || file.find("/arduino/") != std::string::npos ||
         file.starts_with("/usr/") || file.starts_with("../");  // files of newlib and libgcc
}

DebugInfo::DebugInfo(const std::filesystem::path& file) : content_(read_file(file)) {
  ::elf_version(EV_CURRENT);
  elf_ = ::elf_memory(content_.data(), content_.size());
  if (elf_) dwarf_ = dwarf_begin_elf(elf_, DWARF_C_READ, nullptr);
  if (!dwarf_ || !names_other_files(elf_, dwarf_)) return;
  dwarf_end(dwarf_);
  dwarf_ = nullptr;
}

DebugInfo::~DebugInfo() {
  if (dwarf_) dwarf_end(dwarf_);
  if (elf_) ::elf_end(elf_);
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
      at.function = function_name(name_of(scopes[i]));
      frames.push_back(at);
      at = call_of(unit, scopes[i]);
    }
  });
  return frames;
}

template <class Wanted>
const SourceLine& DebugInfo::first(std::map<std::uint32_t, SourceLine>& places, std::uint32_t pc,
                                   Wanted wanted) const {
  const auto [known, is_new] = places.try_emplace(pc);
  if (!is_new) return known->second;
  for (SourceLine& frame : frames(pc)) {
    if (!wanted(frame.file)) continue;
    known->second = std::move(frame);
    break;
  }
  return known->second;
}

const SourceLine& DebugInfo::place(std::uint32_t pc) const {
  return first(places_, pc, [](const std::string& file) { return !is_core_file(file); });
}

const SourceLine& DebugInfo::sketch_place(std::uint32_t pc) const {
  return first(sketch_places_, pc, [](const std::string& file) {
    return !is_core_file(file) && !file.starts_with("libraries/");
  });
}

std::vector<DebugInfo::CodeLine> DebugInfo::lines() const {
  std::vector<CodeLine> all;
  if (dwarf_)
    for_each_unit(dwarf_, [&](Dwarf_Die unit) {
      std::vector<CodeLine> calls;
      add_rows(unit, all);
      add_calls(unit, unit, calls);
      std::set<std::pair<std::string_view, int>> known;
      for (const CodeLine& row : all) known.emplace(row.file, row.line);
      std::erase_if(calls, [&](const CodeLine& call) { return known.contains({call.file, call.line}); });
      all.insert(all.end(), calls.begin(), calls.end());
    });
  std::erase_if(all, [](const CodeLine& line) { return line.line <= 0 || is_core_file(line.file); });
  return all;
}

DebugInfo::CodeOf DebugInfo::code_of(const std::string& function) const {
  CodeOf code;
  if (dwarf_) for_each_unit(dwarf_, [&](Dwarf_Die unit) { find_code(unit, function, code); });
  return code;
}

}  // namespace robosim::exec
