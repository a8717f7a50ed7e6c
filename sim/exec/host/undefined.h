// Explains findings of gcc's UndefinedBehaviorSanitizer. gcc passes a name and the data of its handlers,
// which are those of LLVM's compiler-rt (lib/ubsan/ubsan_handlers.h).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "sim/exec/core/executor.h"

namespace robosim::exec {

/// The data of gcc's handlers, as far as they are common to all.
namespace ubsan {

struct Location {
  const char* file;
  std::uint32_t line;
  std::uint32_t column;
};

struct Type {
  enum Kind : std::uint16_t { integer = 0, floating = 1 };
  std::uint16_t kind;
  std::uint16_t info;  ///< integer: 2 * log2(bits), + 1 if signed; floating: bits
  char name[1];        ///< "'int'"
};

struct OneType {
  Location at;
  const Type* type;
};

struct TwoTypes {
  Location at;
  const Type* first;
  const Type* second;
};

}  // namespace ubsan

struct Undefined {
  std::string check;   ///< its name
  std::string reason;  ///< a clause, as in Crash
  std::string file;    ///< as debug information names it; empty if gcc does not pass it
  int line = 0;
};

/// `check` is the handler's name without "__ubsan_handle_"; `data` and the values are the handler's
/// arguments.
Undefined explain_undefined(std::string_view check, const void* data, std::uintptr_t value,
                            std::uintptr_t other);
/// Takes file and line of the fault, if it has them and they are the sketch's.
void take_place(const Undefined& fault, SourceLine& place);

}  // namespace robosim::exec
