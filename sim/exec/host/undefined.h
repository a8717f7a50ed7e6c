// Explains findings of gcc's UndefinedBehaviorSanitizer. The handlers that gcc calls have the names and data
// of LLVM's compiler-rt (lib/ubsan/ubsan_handlers.h).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "sim/exec/core/executor.h"

namespace robosim::exec {

/// The data that gcc passes to the handlers.
namespace ubsan {

struct Location {
  const char* file;
  std::uint32_t line;
  std::uint32_t column;
};

struct Type {
  enum Kind : std::uint16_t { integer = 0, floating = 1 };
  std::uint16_t kind;
  std::uint16_t info;  ///< integer: 2 * log2(bits), + 1 if signed; floating: number of bits
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
  std::string check;   ///< name of the check: "mul_overflow"
  std::string reason;  ///< a clause for Crash::reason
  std::string file;    ///< path of the source file; empty if gcc does not pass the path
  int line = 0;
};

/// Explains a failed check. `check` is the handler's name without "__ubsan_handle_"; `data`, `value` and
/// `other` are the handler's arguments.
Undefined explain_undefined(std::string_view check, const void* data, std::uintptr_t value,
                            std::uintptr_t other);
/// Copies the file and line of the fault to `place`, if the file is known and belongs to the sketch.
void take_place(const Undefined& fault, SourceLine& place);

}  // namespace robosim::exec
