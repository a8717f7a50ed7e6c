// Implements DebugInfo::variable_at() and DebugInfo::numbers(). DWARF contains the addresses of variables and
// the offsets of members.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "sim/exec/elf/debug_info.h"
#include "sim/exec/elf/dwarf_access.h"

namespace robosim::exec {
namespace {

// Limits of chained typedefs, members and elements, and path lengths. They end the search in damaged files.
// Compiled programs stay far below these limits.
constexpr int kMostNames = 64, kMostParts = 60'000;
constexpr std::size_t kLongestPath = 1000;

std::optional<Dwarf_Die> type_of(Dwarf_Die die) {
  Dwarf_Attribute attribute;
  Dwarf_Die type = die;
  int names = 0;
  do {
    Dwarf_Die next;
    if (++names > kMostNames || !dwarf_attr_integrate(&type, DW_AT_type, &attribute) ||
        !dwarf_formref_die(&attribute, &next))
      return std::nullopt;
    type = next;
  } while (dwarf_tag(&type) == DW_TAG_const_type || dwarf_tag(&type) == DW_TAG_volatile_type ||
           dwarf_tag(&type) == DW_TAG_typedef);
  return type;
}

Dwarf_Word size_of(Dwarf_Die type) {
  Dwarf_Word size = 0;
  return dwarf_aggregate_size(&type, &size) == 0 ? size : 0;
}

SourceLine declaration_of(Dwarf_Die variable) {
  SourceLine where{.file = tidy_file(dwarf_decl_file(&variable))};
  dwarf_decl_line(&variable, &where.line);
  return where;
}

bool has_constructor(DwarfSearch& search, Dwarf_Die type) {
  const std::string_view name = name_of(type);
  return !name.empty() && search.any_child(type, [&](Dwarf_Die child) {
    return dwarf_tag(&child) == DW_TAG_subprogram && name_of(child) == name &&
           !dwarf_hasattr(&child, DW_AT_artificial);
  });
}

/// Returns the offset of a member or base class; empty for any other DIE.
std::optional<Dwarf_Word> member_offset(Dwarf_Die die) {
  const int tag = dwarf_tag(&die);
  if (tag != DW_TAG_member && tag != DW_TAG_inheritance) return std::nullopt;
  return number_of(die, DW_AT_data_member_location);
}

/// Returns the path of the member at this offset, such as ".left.pwm"; empty if there is no member. Sets
/// `where` to the member's declaration. If a class that contains the member has a constructor, sets `where`
/// to an empty line.
std::string member_at(DwarfSearch& search, Dwarf_Die type, Dwarf_Word offset, SourceLine& where,
                      bool constructed = false, int depth = 0) {
  if (depth > kMostNames) return "";
  const int tag = dwarf_tag(&type);
  if (tag == DW_TAG_array_type) {
    const auto element = type_of(type);
    const Dwarf_Word size = element ? size_of(*element) : 0;
    return size == 0 ? "" : member_at(search, *element, offset % size, where, constructed, depth + 1);
  }
  std::string path;
  if (tag != DW_TAG_structure_type && tag != DW_TAG_class_type) return path;
  search.any_child(type, [&](Dwarf_Die child) {
    const auto begin = member_offset(child);
    const auto of = begin ? type_of(child) : std::nullopt;
    if (!of || offset < *begin || offset >= *begin + size_of(*of)) return false;
    const bool sets = constructed || has_constructor(search, type);
    if (dwarf_tag(&child) == DW_TAG_member && !name_of(child).empty()) {
      path.append(1, '.').append(name_of(child));
      where = sets ? SourceLine{} : declaration_of(child);
    }
    path.append(member_at(search, *of, offset - *begin, where, sets, depth + 1));
    return true;
  });
  return path;
}

/// Returns the address of a variable; empty if the variable has no fixed address.
std::optional<Dwarf_Word> address_of(Dwarf_Die variable) {
  Dwarf_Attribute attribute;
  Dwarf_Op* operations = nullptr;
  std::size_t count = 0;
  if (dwarf_tag(&variable) != DW_TAG_variable ||
      !dwarf_attr_integrate(&variable, DW_AT_location, &attribute) ||
      dwarf_getlocation(&attribute, &operations, &count) != 0 || count != 1 ||
      operations[0].atom != DW_OP_addr)
    return std::nullopt;
  return operations[0].number;
}

/// Sets `found` if the DIE is the variable that contains this address. Returns whether it is.
bool contains(DwarfSearch& search, Dwarf_Die die, std::uint32_t address, DebugInfo::Variable& found) {
  const auto begin = address_of(die);
  if (!begin || address < *begin) return false;
  const auto type = type_of(die);
  const Dwarf_Word offset = address - *begin;
  if (!type || offset >= size_of(*type)) return false;
  // The name may be in a separate entry for the declaration, as for a static member.
  Dwarf_Attribute attribute;
  const char* const name =
      dwarf_attr_integrate(&die, DW_AT_name, &attribute) ? dwarf_formstring(&attribute) : nullptr;
  found = {name ? name : "", declaration_of(die), {}};
  found.name.append(member_at(search, *type, offset, found.member));
  return true;
}

/// Collects the numbers of variables.
class NumberCollector {
 public:
  explicit NumberCollector(DwarfSearch& search) : search_(search) {}

  void add_variable(Dwarf_Die die) {
    const auto address = address_of(die);
    const auto type = address ? type_of(die) : std::nullopt;
    if (type && !is_core_file(declaration_of(die).file)) add(*type, *address, "");
  }
  std::vector<DebugInfo::Number> take() { return std::move(numbers_); }

 private:
  /// Adds the numbers of an object of this type.
  void add(Dwarf_Die type, Dwarf_Word address, const std::string& path, int depth = 0) {
    if (depth > kMostNames || path.size() > kLongestPath || ++parts_ > kMostParts) return;
    switch (dwarf_tag(&type)) {
      case DW_TAG_base_type:
      case DW_TAG_enumeration_type:
      case DW_TAG_pointer_type:
        numbers_.push_back(
            {static_cast<std::uint32_t>(address), static_cast<std::uint32_t>(size_of(type)), path});
        return;
      case DW_TAG_array_type:
        return add_elements(type, address, path, depth);
      case DW_TAG_structure_type:
      case DW_TAG_class_type:
        return add_members(type, address, path, depth);
      default:
        return;
    }
  }

  void add_elements(Dwarf_Die array, Dwarf_Word address, const std::string& path, int depth) {
    const auto element = type_of(array);
    const Dwarf_Word size = element ? size_of(*element) : 0;
    const Dwarf_Word count = size > 0 ? size_of(array) / size : 0;
    const std::vector<Dwarf_Word> lengths = lengths_of(array);
    for (Dwarf_Word i = 0; i < count && parts_ <= kMostParts; ++i) {
      std::string index;
      Dwarf_Word rest = i;
      for (auto length = lengths.rbegin(); length != lengths.rend() && *length > 0; ++length) {
        index.insert(0, fmt::format("[{}]", rest % *length));
        rest /= *length;
      }
      add(*element, address + i * size, path + index, depth + 1);
    }
  }

  void add_members(Dwarf_Die type, Dwarf_Word address, const std::string& path, int depth) {
    search_.any_child(type, [&](Dwarf_Die child) {
      const auto offset = member_offset(child);
      const auto of = offset && !dwarf_hasattr(&child, DW_AT_bit_size) ? type_of(child) : std::nullopt;
      const bool is_named = dwarf_tag(&child) == DW_TAG_member && !name_of(child).empty();
      if (of)
        add(*of, address + *offset, is_named ? fmt::format("{}.{}", path, name_of(child)) : path, depth + 1);
      return false;
    });
  }

  /// Returns the length of each dimension of an array.
  std::vector<Dwarf_Word> lengths_of(Dwarf_Die array) const {
    std::vector<Dwarf_Word> lengths;
    search_.any_child(array, [&](Dwarf_Die child) {
      if (dwarf_tag(&child) != DW_TAG_subrange_type) return false;
      if (const auto last = number_of(child, DW_AT_upper_bound))
        lengths.push_back(*last + 1);
      else if (const auto count = number_of(child, DW_AT_count))
        lengths.push_back(*count);
      return lengths.size() > kMostNames;
    });
    return lengths;
  }

  DwarfSearch& search_;
  std::vector<DebugInfo::Number> numbers_;
  int parts_ = 0;
};

}  // namespace

DebugInfo::Variable DebugInfo::variable_at(std::uint32_t address) const {
  Variable found;
  DwarfSearch search(dwarf_, steps_left_);
  search.any_unit([&](Dwarf_Die unit) {
    return search.any_descendant(unit, [&](Dwarf_Die die) { return contains(search, die, address, found); });
  });
  return is_core_file(found.where.file) ? Variable{} : found;
}

std::vector<DebugInfo::Number> DebugInfo::numbers() const {
  DwarfSearch search(dwarf_, steps_left_);
  NumberCollector collector(search);
  search.any_unit([&](Dwarf_Die unit) {
    return search.any_descendant(unit, [&](Dwarf_Die die) { return collector.add_variable(die), false; });
  });
  std::vector<Number> numbers = collector.take();
  std::stable_sort(numbers.begin(), numbers.end(),
                   [](const Number& a, const Number& b) { return a.address < b.address; });
  const auto repeated = std::unique(numbers.begin(), numbers.end(), [](const Number& a, const Number& b) {
    return a.address == b.address && a.size == b.size;
  });
  numbers.erase(repeated, numbers.end());
  return numbers;
}

}  // namespace robosim::exec
