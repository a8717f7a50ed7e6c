// Implements DebugInfo::variable_at(). DWARF contains the addresses of variables and the offsets of members.
#include <dwarf.h>
#include <elfutils/libdw.h>

#include <optional>
#include <string_view>

#include "sim/exec/elf/debug_info.h"

namespace robosim::exec {
namespace {

// Limits of nested scopes and chained typedefs, which end the search in damaged files. Compiled programs stay
// far below these limits.
constexpr int kMostNested = 256, kMostNames = 64;

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

bool find(Dwarf_Die parent, std::uint32_t address, DebugInfo::Variable& found, int depth = 0) {
  Dwarf_Die child;
  if (depth > kMostNested || dwarf_child(&parent, &child) != 0) return false;
  do {
    Dwarf_Attribute attribute;
    Dwarf_Op* operations = nullptr;
    std::size_t count = 0;
    if (dwarf_tag(&child) == DW_TAG_variable && dwarf_attr_integrate(&child, DW_AT_location, &attribute) &&
        dwarf_getlocation(&attribute, &operations, &count) == 0 && count == 1 &&
        operations[0].atom == DW_OP_addr && address >= operations[0].number) {
      const auto type = type_of(child);
      const Dwarf_Word offset = address - operations[0].number;
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

}  // namespace

DebugInfo::Variable DebugInfo::variable_at(std::uint32_t address) const {
  Variable found;
  Dwarf_Off offset = 0, next = 0;
  std::size_t header = 0;
  while (dwarf_ && dwarf_nextcu(dwarf_, offset, &next, &header, nullptr, nullptr, nullptr) == 0) {
    Dwarf_Die unit;
    if (dwarf_offdie(dwarf_, offset + header, &unit) && find(unit, address, found)) break;
    offset = next;
  }
  return is_core_file(found.where.file) ? Variable{} : found;
}

}  // namespace robosim::exec
