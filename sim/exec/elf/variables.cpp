// Implements DebugInfo::variable_at() and DebugInfo::numbers(). DWARF contains the addresses of variables and
// the offsets of members.
#include <dwarf.h>
#include <elfutils/libdw.h>
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "sim/exec/elf/debug_info.h"

namespace robosim::exec {
namespace {

// Limits of nested scopes, chained typedefs, members and elements, and path lengths. They end the search in
// damaged files. Compiled programs stay far below these limits.
constexpr int kMostNested = 256, kMostNames = 64, kMostParts = 60'000;
constexpr std::size_t kLongestPath = 1000;

using VisitUnit = std::function<bool(Dwarf_Die unit)>;

/// Calls `visit` for each compilation unit, until `visit` returns true.
void for_units(Dwarf* dwarf, const VisitUnit& visit) {
  Dwarf_Off offset = 0, next = 0;
  std::size_t header = 0;
  while (dwarf && dwarf_nextcu(dwarf, offset, &next, &header, nullptr, nullptr, nullptr) == 0) {
    Dwarf_Die unit;
    if (dwarf_offdie(dwarf, offset + header, &unit) && visit(unit)) return;
    offset = next;
  }
}

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
  SourceLine where;
  if (const char* const file = dwarf_decl_file(&variable)) where.file = file;
  if (where.file.starts_with("./")) where.file.erase(0, 2);
  dwarf_decl_line(&variable, &where.line);
  return where;
}

bool has_constructor(Dwarf_Die type) {
  const char* const name = dwarf_diename(&type);
  Dwarf_Die child;
  if (!name || dwarf_child(&type, &child) != 0) return false;
  do {
    const char* const of = dwarf_tag(&child) == DW_TAG_subprogram ? dwarf_diename(&child) : nullptr;
    if (of && std::string_view(of) == name && !dwarf_hasattr(&child, DW_AT_artificial)) return true;
  } while (dwarf_siblingof(&child, &child) == 0);
  return false;
}

/// Returns the path of the member at this offset, such as ".left.pwm"; empty if there is no member. Sets
/// `where` to the member's declaration. If a class that contains the member has a constructor, sets `where`
/// to an empty line.
std::string member_at(Dwarf_Die type, Dwarf_Word offset, SourceLine& where, bool constructed = false,
                      int depth = 0) {
  if (depth > kMostNames) return "";
  Dwarf_Die child;
  const int tag = dwarf_tag(&type);
  if (tag == DW_TAG_array_type) {
    const auto element = type_of(type);
    const Dwarf_Word size = element ? size_of(*element) : 0;
    return size == 0 ? "" : member_at(*element, offset % size, where, constructed, depth + 1);
  }
  if ((tag != DW_TAG_structure_type && tag != DW_TAG_class_type) || dwarf_child(&type, &child) != 0)
    return "";
  do {
    Dwarf_Attribute attribute;
    Dwarf_Word begin = 0;
    if (dwarf_tag(&child) != DW_TAG_member && dwarf_tag(&child) != DW_TAG_inheritance) continue;
    if (!dwarf_attr(&child, DW_AT_data_member_location, &attribute) ||
        dwarf_formudata(&attribute, &begin) != 0)
      continue;
    const auto of = type_of(child);
    if (!of || offset < begin || offset >= begin + size_of(*of)) continue;
    std::string path;
    const bool sets = constructed || has_constructor(type);
    if (const char* const name = dwarf_diename(&child); name && dwarf_tag(&child) == DW_TAG_member) {
      path.append(1, '.').append(name);
      where = sets ? SourceLine{} : declaration_of(child);
    }
    return path.append(member_at(*of, offset - begin, where, sets, depth + 1));
  } while (dwarf_siblingof(&child, &child) == 0);
  return "";
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

bool find(Dwarf_Die parent, std::uint32_t address, DebugInfo::Variable& found, int depth = 0) {
  Dwarf_Die child;
  if (depth > kMostNested || dwarf_child(&parent, &child) != 0) return false;
  do {
    Dwarf_Attribute attribute;
    if (const auto begin = address_of(child); begin && address >= *begin) {
      const auto type = type_of(child);
      const Dwarf_Word offset = address - *begin;
      if (type && offset < size_of(*type)) {
        // The name may be in a separate entry for the declaration, as for a static member.
        const char* const name =
            dwarf_attr_integrate(&child, DW_AT_name, &attribute) ? dwarf_formstring(&attribute) : nullptr;
        found = {name ? name : "", declaration_of(child), {}};
        found.name.append(member_at(*type, offset, found.member));
        return true;
      }
    }
    if (find(child, address, found, depth + 1)) return true;
  } while (dwarf_siblingof(&child, &child) == 0);
  return false;
}

/// Collects the numbers of variables.
class NumberCollector {
 public:
  void add_variables(Dwarf_Die parent, int depth = 0) {
    Dwarf_Die child;
    if (depth > kMostNested || dwarf_child(&parent, &child) != 0) return;
    do {
      const auto address = address_of(child);
      const auto type = address ? type_of(child) : std::nullopt;
      if (type && !is_core_file(declaration_of(child).file)) add(*type, *address, "");
      add_variables(child, depth + 1);
    } while (dwarf_siblingof(&child, &child) == 0);
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
    Dwarf_Die child;
    if (dwarf_child(&type, &child) != 0) return;
    do {
      Dwarf_Attribute attribute;
      Dwarf_Word offset = 0;
      const int tag = dwarf_tag(&child);
      if ((tag != DW_TAG_member && tag != DW_TAG_inheritance) || dwarf_hasattr(&child, DW_AT_bit_size) ||
          !dwarf_attr(&child, DW_AT_data_member_location, &attribute) ||
          dwarf_formudata(&attribute, &offset) != 0)
        continue;
      const char* const name = tag == DW_TAG_member ? dwarf_diename(&child) : nullptr;
      if (const auto of = type_of(child))
        add(*of, address + offset, name ? fmt::format("{}.{}", path, name) : path, depth + 1);
    } while (dwarf_siblingof(&child, &child) == 0);
  }

  /// Returns the length of each dimension of an array.
  static std::vector<Dwarf_Word> lengths_of(Dwarf_Die array) {
    std::vector<Dwarf_Word> lengths;
    Dwarf_Die child;
    if (dwarf_child(&array, &child) != 0) return lengths;
    do {
      Dwarf_Attribute attribute;
      Dwarf_Word value = 0;
      if (dwarf_tag(&child) != DW_TAG_subrange_type || lengths.size() > kMostNames) continue;
      if (dwarf_attr(&child, DW_AT_upper_bound, &attribute) && dwarf_formudata(&attribute, &value) == 0)
        lengths.push_back(value + 1);
      else if (dwarf_attr(&child, DW_AT_count, &attribute) && dwarf_formudata(&attribute, &value) == 0)
        lengths.push_back(value);
    } while (dwarf_siblingof(&child, &child) == 0);
    return lengths;
  }

  std::vector<DebugInfo::Number> numbers_;
  int parts_ = 0;
};

}  // namespace

DebugInfo::Variable DebugInfo::variable_at(std::uint32_t address) const {
  Variable found;
  for_units(dwarf_, [&](Dwarf_Die unit) { return find(unit, address, found); });
  return is_core_file(found.where.file) ? Variable{} : found;
}

std::vector<DebugInfo::Number> DebugInfo::numbers() const {
  NumberCollector collector;
  for_units(dwarf_, [&](Dwarf_Die unit) { return collector.add_variables(unit), false; });
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
