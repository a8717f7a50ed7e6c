// Converts a linker symbol to the variable's name in the sketch (C++ demangling).
#pragma once

#include <cxxabi.h>

#include <cstdlib>
#include <memory>
#include <string>

namespace robosim::exec::avr {

inline std::string demangle(const std::string& symbol) {
  if (!symbol.starts_with("_Z")) return symbol;  // else `n` would be the type __int128
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(
      abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status), &std::free);
  return status == 0 ? name.get() : symbol;
}

}  // namespace robosim::exec::avr
