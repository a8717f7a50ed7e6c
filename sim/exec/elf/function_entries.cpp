// Implements DebugInfo::entries_of(). DWARF contains the addresses at which a function and its inlined copies
// begin. It also names the registers that contain the parameters at these addresses (DWARF 4, 2.6 and 3.3.8).
#include <algorithm>

#include "sim/exec/elf/debug_info.h"
#include "sim/exec/elf/dwarf_access.h"

namespace robosim::exec {
namespace {

// Limits, which end the search in damaged files.
constexpr std::size_t kMostEntries = 4096, kMostParameters = 16, kMostBegins = 256;

/// Returns the DIEs of a function's parameters, in the order of the declaration.
std::vector<Dwarf_Die> parameters_of(DwarfSearch& search, Dwarf_Die function) {
  std::vector<Dwarf_Die> all;
  search.any_child(function, [&](Dwarf_Die child) {
    if (dwarf_tag(&child) == DW_TAG_formal_parameter) all.push_back(child);
    return all.size() >= kMostParameters;
  });
  return all;
}

Dwarf_Die origin_of(Dwarf_Die die) {
  Dwarf_Attribute attribute;
  Dwarf_Die origin;
  return dwarf_attr(&die, DW_AT_abstract_origin, &attribute) && dwarf_formref_die(&attribute, &origin)
             ? origin
             : die;
}

/// Returns the location of a parameter before the instruction at `pc` runs.
DebugInfo::Argument argument_at(Dwarf_Die parameter, Dwarf_Addr pc) {
  DebugInfo::Argument argument;
  Dwarf_Attribute attribute;
  Dwarf_Sword constant = 0;
  if (dwarf_attr(&parameter, DW_AT_const_value, &attribute) && dwarf_formsdata(&attribute, &constant) == 0)
    argument.constant = constant;
  Dwarf_Op* operations = nullptr;
  std::size_t count = 0;
  if (!dwarf_attr(&parameter, DW_AT_location, &attribute) ||
      dwarf_getlocation_addr(&attribute, pc, &operations, &count, 1) != 1)
    return argument;
  if (count == 2 && operations[1].atom == DW_OP_stack_value) {
    const Dwarf_Op& value = operations[0];
    if (value.atom >= DW_OP_lit0 && value.atom <= DW_OP_lit31) argument.constant = value.atom - DW_OP_lit0;
    if (value.atom >= DW_OP_const1u && value.atom <= DW_OP_consts)
      argument.constant = static_cast<std::int64_t>(value.number);
    return argument;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t atom = operations[i].atom;
    if (atom >= DW_OP_reg0 && atom <= DW_OP_reg31)
      argument.registers.push_back(static_cast<std::uint8_t>(atom - DW_OP_reg0));
    else if (atom != DW_OP_piece || operations[i].number != 1)
      return {};
  }
  return argument;
}

/// Adds the addresses at which the locations of a parameter become valid. Returns false if the parameter has
/// too many locations.
bool add_begins(Dwarf_Die parameter, std::vector<Dwarf_Addr>& begins) {
  Dwarf_Attribute attribute;
  Dwarf_Addr base = 0, begin = 0, end = 0;
  Dwarf_Op* operations = nullptr;
  std::size_t count = 0;
  if (!dwarf_attr(&parameter, DW_AT_location, &attribute)) return true;
  std::ptrdiff_t next = 0;
  for (std::size_t i = 0; i < kMostBegins; ++i, begins.push_back(begin))
    if ((next = dwarf_getlocations(&attribute, next, &base, &begin, &end, &operations, &count)) <= 0)
      return true;
  return false;
}

/// Returns the function's parameters in the order of the declaration; nullopt for a declared parameter that
/// the DIE `function` does not contain.
std::vector<std::optional<Dwarf_Die>> parameters_here(DwarfSearch& search, Dwarf_Die function) {
  std::vector<std::optional<Dwarf_Die>> all;
  const std::vector<Dwarf_Die> here = parameters_of(search, function);
  for (Dwarf_Die declared : parameters_of(search, origin_of(function))) {
    const auto its = std::find_if(here.begin(), here.end(), [&](const Dwarf_Die& one) {
      Dwarf_Die origin = origin_of(one);
      return dwarf_dieoffset(&origin) == dwarf_dieoffset(&declared);
    });
    all.push_back(its == here.end() ? std::nullopt : std::optional(*its));
  }
  return all;
}

/// Returns the largest contiguous part of a function's code.
DebugInfo::Range body_of(DwarfSearch& search, Dwarf_Die function) {
  DebugInfo::Range body;
  for (const DebugInfo::Range part : search.ranges_of(function))
    if (part.end - part.begin > body.end - body.begin) body = part;
  return body;
}

/// Returns the entry into a function. The compiler may move single instructions of an inlined function to an
/// earlier place, even before the condition of the call. Therefore the entry is in the largest part of the
/// function's code. Of its addresses, the entry is the first with the largest number of known parameters.
DebugInfo::Entry entry_of(DwarfSearch& search, Dwarf_Die function) {
  std::vector<std::optional<Dwarf_Die>> parameters = parameters_here(search, function);
  const DebugInfo::Range body = body_of(search, function);
  std::vector<Dwarf_Addr> addresses;
  for (std::optional<Dwarf_Die>& one : parameters)
    if (one && !add_begins(*one, addresses)) one.reset();
  addresses.push_back(body.begin);
  std::erase_if(addresses, [&](Dwarf_Addr one) { return one < body.begin || one >= body.end; });
  std::sort(addresses.begin(), addresses.end());
  DebugInfo::Entry best;
  std::ptrdiff_t most = -1;
  const std::size_t locations = addresses.size();
  for (const Dwarf_Addr address : addresses) {
    if (!search.spend(locations)) break;
    DebugInfo::Entry entry{static_cast<std::uint32_t>(address), false, {}};
    for (const std::optional<Dwarf_Die>& one : parameters)
      entry.arguments.push_back(one ? argument_at(*one, address) : DebugInfo::Argument{});
    const auto known =
        std::count_if(entry.arguments.begin(), entry.arguments.end(),
                      [](const auto& argument) { return argument.constant || !argument.registers.empty(); });
    if (known > most) best = std::move(entry), most = known;
  }
  best.is_inlined = dwarf_tag(&function) == DW_TAG_inlined_subroutine;
  return best;
}

}  // namespace

std::vector<DebugInfo::Entry> DebugInfo::entries_of(const std::string& function) const {
  std::vector<Entry> entries;
  DwarfSearch search(dwarf_, steps_left_);
  search.any_unit([&](Dwarf_Die unit) {
    return search.any_descendant(unit, [&](Dwarf_Die die) {
      if (is_code(die) && name_of(die) == function)
        if (Entry entry = entry_of(search, die); entry.address != 0) entries.push_back(std::move(entry));
      return entries.size() >= kMostEntries;
    });
  });
  return entries;
}

}  // namespace robosim::exec
