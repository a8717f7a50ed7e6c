// What a check of gcc's UndefinedBehaviorSanitizer has found, in words. gcc says it by a name and the data of
// its handlers, which are those of LLVM's compiler-rt (lib/ubsan/ubsan_handlers.h describes them).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace robosim::executors {

struct Undefined {
  std::string reason;  ///< a clause, as in Crash
  std::string file;    ///< as debug information names it; empty where gcc does not tell
  int line = 0;
};

/// `check` is the handler's name without "__ubsan_handle_"; `data` and the values are what it was given.
Undefined explain_undefined(std::string_view check, const void* data, std::uintptr_t value,
                            std::uintptr_t other);

}  // namespace robosim::executors
