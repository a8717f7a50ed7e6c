// A runner's conversation with its client: JSON lines in, JSON lines out (docs/runner-protocol.md).
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "sim/exec/core/executor.h"

namespace robosim {
struct BoardSpec;
}

namespace robosim::runner {

/// What makes one runner program different from another.
struct ExecutorFactory {
  std::string target;  ///< "host"
  std::function<std::unique_ptr<exec::Executor>(const BoardSpec&, const std::filesystem::path& image)> make;
};

/// Serves requests from standard input until it ends. Returns the process's exit status.
int serve(const ExecutorFactory& factory);

}  // namespace robosim::runner
