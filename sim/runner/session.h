// A runner's conversation with its client: JSON lines in, JSON lines out (docs/reference/runner-protocol.md).
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

/// The parts in which runner programs differ.
struct ExecutorFactory {
  std::string target;  ///< "host"
  std::function<std::unique_ptr<exec::Executor>(const BoardSpec&, const std::filesystem::path& image)> make;
  /// For native firmware, whose process is confined: prepares the executor from make() for that
  /// (HostExecutor::prepare_for_confinement). Else empty.
  std::function<void(exec::Executor&, exec::AddressLines, std::shared_ptr<const exec::ImageContent> image)>
      prepare_for_confinement = nullptr;
  /// The other targets whose firmware it runs, in runs of several robots.
  std::vector<ExecutorFactory> besides = {};
};

/// Serves requests from standard input until it ends. Returns the process's exit status.
int serve(const ExecutorFactory& factory);

}  // namespace robosim::runner
