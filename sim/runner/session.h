// Serves a runner's client: receives and sends JSON lines (docs/reference/runner-protocol.md).
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

/// Makes the executors of a target. Runner programs differ only in their factories.
struct ExecutorFactory {
  std::string target;  ///< name of the target, such as "host"
  std::function<std::unique_ptr<exec::Executor>(const BoardSpec&, const std::filesystem::path& image)> make;
  /// Prepares the executor from make() for confinement (HostExecutor::prepare_for_confinement). Empty for
  /// emulated chips: only a process that runs native code is confined.
  std::function<void(exec::Executor&, exec::AddressLines, std::shared_ptr<const exec::ImageContent> image)>
      prepare_for_confinement = nullptr;
  /// The other targets that this runner supports in runs of several robots.
  std::vector<ExecutorFactory> besides = {};
};

/// Serves requests from standard input until the input ends. Returns the process's exit status.
int serve(const ExecutorFactory& factory);

}  // namespace robosim::runner
