// Compiles a user's own navigation algorithm, one C++ file, for the robot on cells
// (docs/reference/algorithms.md).
#pragma once

#include <filesystem>

#include "sim/build/cache.h"

namespace robosim::build {

/// A shared object that is deleted together with this.
class Algorithm {
 public:
  /// Compiles `source`. Throws InputError (no such file), CompileError with the compiler's messages, or
  /// ToolMissing.
  explicit Algorithm(const std::filesystem::path& source);
  std::filesystem::path shared_object() const { return folder_.path() / "algorithm.so"; }

 private:
  WorkFolder folder_;
};

}  // namespace robosim::build
