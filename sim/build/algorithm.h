// Compiles a user's navigation algorithm, one C++ file, to a shared object. The algorithm controls a robot
// that moves from cell to cell on a grid (docs/reference/algorithms.md).
#pragma once

#include <filesystem>

#include "sim/build/cache.h"

namespace robosim::build {

/// The compiled shared object, in a folder that the destructor removes.
class Algorithm {
 public:
  /// Compiles `source`. Throws InputError if the file is missing, CompileError with the compiler's messages,
  /// or ToolMissing.
  explicit Algorithm(const std::filesystem::path& source);
  std::filesystem::path shared_object() const { return folder_.path() / "algorithm.so"; }

 private:
  WorkFolder folder_;
};

}  // namespace robosim::build
