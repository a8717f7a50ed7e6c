#include "sim/exec/elf/debug_info.h"

#include <fmt/format.h>

#include <cstdint>
#include <set>
#include <string_view>
#include <utility>

#include "sim/base/file.h"
#include "sim/exec/elf/demangle.h"
#include "sim/exec/elf/dwarf_access.h"

namespace robosim::exec {
namespace {

// Limit of lines, which ends the search in damaged files. Compiled programs stay far below this limit.
constexpr std::size_t kMostRows = 300'000;

/// Collects the functions and inlined functions that contain `pc`, from the outermost to the innermost.
/// Returns whether there are any.
bool find_scopes(DwarfSearch& search, Dwarf_Die parent, Dwarf_Addr pc, std::vector<Dwarf_Die>& scopes,
                 int depth = 0) {
  return depth <= kMostNested && search.any_child(parent, [&](Dwarf_Die child) {
    const bool is_function = is_code(child);
    if (!is_function && dwarf_tag(&child) != DW_TAG_lexical_block) return false;
    if (!search.may_contain(child, pc)) return false;
    if (is_function) scopes.push_back(child);
    return find_scopes(search, child, pc, scopes, depth + 1) || is_function;
  });
}

bool is_free_function(Dwarf_Die& die, const std::string& name) {
  if (name_of(die) != name) return false;
  Dwarf_Attribute attribute;
  if (!dwarf_attr_integrate(&die, DW_AT_linkage_name, &attribute)) return true;
  const char* const linkage = dwarf_formstring(&attribute);
  return linkage && (linkage == name || linkage == fmt::format("_Z{}{}v", name.size(), name));
}

/// Returns the file and line of the call that the compiler has inlined.
SourceLine call_of(Dwarf_Die& unit, Dwarf_Die& inlined) {
  SourceLine place;
  place.line = static_cast<int>(number_of(inlined, DW_AT_call_line).value_or(0));
  const auto file = number_of(inlined, DW_AT_call_file);
  Dwarf_Files* files = nullptr;
  std::size_t count = 0;
  if (file && dwarf_getsrcfiles(&unit, &files, &count) == 0 && *file < count)
    place.file = tidy_file(dwarf_filesrc(files, *file, nullptr, nullptr));
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
    DebugInfo::CodeLine line{static_cast<std::uint32_t>(address),
                             tidy_file(dwarf_linesrc(row, nullptr, nullptr))};
    dwarf_lineno(row, &line.line);
    lines.push_back(std::move(line));
  }
}

/// Adds the lines of calls that were inlined. Such a line may have no other code.
void add_calls(DwarfSearch& search, Dwarf_Die& unit, std::vector<DebugInfo::CodeLine>& lines) {
  search.any_descendant(unit, [&](Dwarf_Die die) {
    Dwarf_Addr base = 0, begin = 0, end = 0;
    const bool inlined = dwarf_tag(&die) == DW_TAG_inlined_subroutine;
    if (inlined && (dwarf_entrypc(&die, &begin) == 0 || dwarf_ranges(&die, 0, &base, &begin, &end) > 0) &&
        begin != 0) {
      const SourceLine call = call_of(unit, die);
      lines.push_back({static_cast<std::uint32_t>(begin), call.file, call.line});
    }
    return lines.size() >= kMostRows;
  });
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
  DwarfSearch search(dwarf_, steps_left_);
  search.any_unit([&](Dwarf_Die unit) {
    std::vector<Dwarf_Die> scopes;
    if (!search.may_contain(unit, pc) || !find_scopes(search, unit, pc, scopes)) return false;
    SourceLine at;
    if (Dwarf_Line* line = dwarf_getsrc_die(&unit, pc)) {
      dwarf_lineno(line, &at.line);
      at.file = tidy_file(dwarf_linesrc(line, nullptr, nullptr));
    }
    for (std::size_t i = scopes.size(); i-- > 0;) {
      at.function = function_name(std::string(name_of(scopes[i])));
      frames.push_back(at);
      at = call_of(unit, scopes[i]);
    }
    return true;
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
  DwarfSearch search(dwarf_, steps_left_);
  search.any_unit([&](Dwarf_Die unit) {
    std::vector<CodeLine> calls;
    add_rows(unit, all);
    add_calls(search, unit, calls);
    std::set<std::pair<std::string_view, int>> known;
    for (const CodeLine& row : all) known.emplace(row.file, row.line);
    std::erase_if(calls, [&](const CodeLine& call) { return known.contains({call.file, call.line}); });
    all.insert(all.end(), calls.begin(), calls.end());
    return false;
  });
  std::erase_if(all, [](const CodeLine& line) { return line.line <= 0 || is_core_file(line.file); });
  return all;
}

DebugInfo::CodeOf DebugInfo::code_of(const std::string& function) const {
  CodeOf code;
  DwarfSearch search(dwarf_, steps_left_);
  search.any_unit([&](Dwarf_Die unit) {
    return search.any_descendant(unit, [&](Dwarf_Die die) {
      if (!is_code(die) || !is_free_function(die, function)) return false;
      auto& ranges = dwarf_tag(&die) == DW_TAG_subprogram ? code.itself : code.inlined;
      for (const Range range : search.ranges_of(die)) ranges.push_back(range);
      return ranges.size() >= kMostRanges;
    });
  });
  return code;
}

}  // namespace robosim::exec
