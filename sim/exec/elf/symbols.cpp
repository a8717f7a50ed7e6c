#include "sim/exec/elf/symbols.h"

#include <algorithm>

namespace robosim::exec {

void Symbols::sort() {
  std::stable_sort(all_.begin(), all_.end(),
                   [](const Symbol& a, const Symbol& b) { return a.address < b.address; });
}

const Symbol* Symbols::find(const std::string& name) const {
  for (const Symbol& symbol : all_)
    if (symbol.name == name) return &symbol;
  return nullptr;
}

const Symbol* Symbols::function_at(std::uint32_t address) const {
  const Symbol* best = nullptr;
  for (const Symbol& symbol : all_) {
    if (symbol.address > address) break;
    if (symbol.code && (symbol.size == 0 || address < symbol.address + symbol.size)) best = &symbol;
  }
  return best;
}

const Symbol* Symbols::variable_at(std::uint32_t address) const {
  for (const Symbol& symbol : all_)
    if (!symbol.code && address >= symbol.address && address < symbol.address + symbol.size) return &symbol;
  return nullptr;
}

}  // namespace robosim::exec
