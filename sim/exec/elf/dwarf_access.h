// Reads units, scopes and attributes of DWARF, for the files in this folder that search debug information.
#pragma once

#include <dwarf.h>
#include <elfutils/libdw.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/exec/elf/debug_info.h"

namespace robosim::exec {

// Limits of nested scopes, ranges of a function, and name lengths. They end the search in damaged files.
// Compiled programs stay far below these limits.
inline constexpr int kMostNested = 256;
inline constexpr std::size_t kMostRanges = 4096, kLongestName = 1000;

/// Searches debug information, which consists of entries (DIEs). Hostile information could make a search
/// endless: a DIE may be its own sibling, and any number of DIEs may share a long table. Therefore each DIE
/// and each row of a table costs a step. A search that has used up its steps finds nothing more.
class DwarfSearch {
 public:
  /// `steps_left` must outlive the search, which reduces it.
  DwarfSearch(Dwarf* dwarf, std::int64_t& steps_left) : dwarf_(dwarf), steps_left_(steps_left) {}

  /// Subtracts `steps` from the remaining steps. Returns false if fewer steps remained.
  bool spend(std::size_t steps = 1) {
    steps_left_ -= static_cast<std::int64_t>(steps);
    return steps_left_ >= 0;
  }

  /// Calls `visit` for each compilation unit, until `visit` returns true. Returns whether it did.
  template <typename Visit>
  bool any_unit(Visit visit) {
    Dwarf_CU* unit = nullptr;
    Dwarf_Die die;
    while (dwarf_ && spend() && dwarf_get_units(dwarf_, unit, &unit, nullptr, nullptr, &die, nullptr) == 0)
      if (visit(die)) return true;
    return false;
  }

  /// Calls `visit` for each child of a DIE, until `visit` returns true. Returns whether it did.
  template <typename Visit>
  bool any_child(Dwarf_Die parent, Visit visit) {
    Dwarf_Die child;
    if (dwarf_child(&parent, &child) != 0) return false;
    do {
      if (!spend()) return false;
      if (visit(child)) return true;
    } while (dwarf_siblingof(&child, &child) == 0);
    return false;
  }

  /// Calls `visit` for each DIE below a DIE, parents first, until `visit` returns true. Returns whether it
  /// did.
  template <typename Visit>
  bool any_descendant(Dwarf_Die parent, const Visit& visit, int depth = 0) {
    return depth <= kMostNested && any_child(parent, [&](Dwarf_Die child) {
             return visit(child) || any_descendant(child, visit, depth + 1);
           });
  }

  /// Returns whether the code of a DIE contains the address. Returns true for a unit without addresses.
  bool may_contain(Dwarf_Die die, Dwarf_Addr pc) {
    Dwarf_Addr base = 0, begin = 0, end = 0;
    std::ptrdiff_t next = 0;
    bool has_ranges = false;
    for (; spend() && (next = dwarf_ranges(&die, next, &base, &begin, &end)) > 0; has_ranges = true)
      if (begin <= pc && pc < end) return true;
    return !has_ranges && next == 0 && dwarf_tag(&die) == DW_TAG_compile_unit;
  }

  /// Returns the contiguous parts of a function's code.
  std::vector<DebugInfo::Range> ranges_of(Dwarf_Die function) {
    std::vector<DebugInfo::Range> ranges;
    Dwarf_Addr base = 0, begin = 0, end = 0;
    for (std::ptrdiff_t next = 0; ranges.size() < kMostRanges && spend() &&
                                  (next = dwarf_ranges(&function, next, &base, &begin, &end)) > 0;)
      ranges.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)});
    return ranges;
  }

 private:
  Dwarf* const dwarf_;
  std::int64_t& steps_left_;
};

/// Returns the name of a DIE, or an empty text if it has none.
inline std::string_view name_of(Dwarf_Die die) {
  const char* const name = dwarf_diename(&die);
  return name ? name : "";
}

/// Returns the value of an attribute that is a number.
inline std::optional<Dwarf_Word> number_of(Dwarf_Die die, unsigned name) {
  Dwarf_Attribute attribute;
  Dwarf_Word value = 0;
  if (!dwarf_attr(&die, name, &attribute) || dwarf_formudata(&attribute, &value) != 0) return std::nullopt;
  return value;
}

/// Returns a file's name without a leading "./".
inline std::string tidy_file(const char* file) {
  const std::string_view name(file ? file : "", file ? strnlen(file, kLongestName) : 0);
  return std::string(name.starts_with("./") ? name.substr(2) : name);
}

/// Returns whether the DIE is a function or an inlined copy of one.
inline bool is_code(Dwarf_Die die) {
  const int tag = dwarf_tag(&die);
  return tag == DW_TAG_subprogram || tag == DW_TAG_inlined_subroutine;
}

}  // namespace robosim::exec
