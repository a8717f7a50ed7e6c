// Names and addresses of a chip's program.
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
  void add(Symbol symbol) { all_.push_back(std::move(symbol)); }
  /// The address after the last byte.
  void sort();

  const Symbol* find(const std::string& name) const;
  /// The function that holds an address; null if none does.
  const Symbol* function_at(std::uint32_t address) const;
  /// The variable that holds an address; null if none does.
  const Symbol* variable_at(std::uint32_t address) const;

 private:
  std::vector<Symbol> all_;  ///< by address
};

}  // namespace robosim::exec
