// Converts names in the linker's form to names as in the sketch (C++ demangling).
#pragma once

#include <cxxabi.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>

namespace robosim::exec {

/// Returns the name of a variable or function with its scopes and parameters: "Motor::set_speed(int)".
inline std::string demangle(const std::string& symbol) {
  if (!symbol.starts_with("_Z")) return symbol;  // else the variable `n` would be named "__int128"
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(
      abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status), &std::free);
  return status == 0 ? name.get() : symbol;
}

/// Returns a function's name without scopes and parameters: "set_speed". The compiler's variants of a
/// function have symbols such as `_ZN5Motor9set_speedEi.isra.0` and `blink.part.0`.
inline std::string function_name(const std::string& symbol) {
  std::string name = demangle(symbol.substr(0, symbol.find('.')));
  name.resize(std::min(name.find('('), name.size()));
  const std::size_t scope = name.rfind("::");
  return scope == name.npos ? name : name.substr(scope + 2);
}

}  // namespace robosim::exec
