// Stores the names and addresses of a program's functions and variables.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace robosim::exec {

struct Symbol {
  std::string name;
  std::uint32_t address = 0;
  std::uint32_t size = 0;
  bool code = false;
};

class Symbols {
 public:
  /// Adds a symbol, unless it is a local label of the assembler. avr-as of binutils 2.43 leaves some such
  /// labels in the image, within functions. They begin with ".L", or contain control-A or control-B (manual
  /// of the GNU assembler, "Symbol Names").
  void add(Symbol symbol) {
    const bool label = symbol.name.starts_with(".L") || symbol.name.find_first_of("\1\2") != symbol.name.npos;
    if (!label) all_.push_back(std::move(symbol));
  }
  /// Sorts the symbols by address. Call it after the last add().
  void sort();

  const Symbol* find(const std::string& name) const;
  /// Returns the function that contains an address, or null.
  const Symbol* function_at(std::uint32_t address) const;
  /// Returns the variable that contains an address, or null.
  const Symbol* variable_at(std::uint32_t address) const;

 private:
  std::vector<Symbol> all_;  ///< sorted by address
};

}  // namespace robosim::exec
