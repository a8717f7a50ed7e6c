#include "sim/build/elf_facts.h"

#include <algorithm>

#include "sim/base/elf/avr_addresses.h"

namespace robosim::build {

ElfSize elf_size(const ElfFile& file) {
  ElfSize size;
  for (const ElfSection& section : file.sections()) {
    if (!section.loaded) continue;
    if (file.is_for_avr() && section.address >= kAvrEeprom) continue;
    (section.writable ? size.data : size.text) += section.size;
    if (section.writable && section.has_content) size.initialised += section.size;
  }
  return size;
}

std::vector<AbsoluteSymbol> absolute_symbols(const ElfFile& file) {
  std::vector<AbsoluteSymbol> found;
  for (const ElfSymbol& symbol : file.symbols())
    if (symbol.absolute) found.push_back({std::string(symbol.name), symbol.value});
  std::sort(found.begin(), found.end(),
            [](const AbsoluteSymbol& a, const AbsoluteSymbol& b) { return a.name < b.name; });
  return found;
}

}  // namespace robosim::build
