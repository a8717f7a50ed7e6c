// A runner's conversation with its client: JSON lines in, JSON lines out (docs/runner-protocol.md).
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sim/exec/core/executor.h"
#include "sim/exec/host/image_file.h"

namespace robosim {
struct BoardSpec;
}

namespace robosim::runner {

/// What makes one runner program different from another.
struct ExecutorFactory {
  std::string target;  ///< "host"
  std::function<std::unique_ptr<exec::Executor>(const BoardSpec&, const std::filesystem::path& image)> make;
  /// Where firmware is code of this machine, and its process is to be confined: what the executor that make()
  /// gave has to do before (HostExecutor::prepare_for_confinement). Else nothing.
  std::function<void(exec::Executor&, exec::AddressLines, std::shared_ptr<const exec::ImageContent> image)>
      prepare_for_confinement = nullptr;
  /// Whose firmware it runs beside, in runs of several robots.
  std::vector<ExecutorFactory> besides = {};
};

/// Serves requests from standard input until it ends. Returns the process's exit status.
int serve(const ExecutorFactory& factory);

}  // namespace robosim::runner
