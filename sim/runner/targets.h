// Provides the target host for runner programs, and combines several targets in one program.
#pragma once

#include "sim/exec/host/host_executor.h"
#include "sim/runner/session.h"

namespace robosim::runner {

inline ExecutorFactory host_target() {
  using exec::HostExecutor;
  return {"host",
          [](const BoardSpec& board, const std::filesystem::path& image) {
            return std::make_unique<HostExecutor>(board, image);
          },
          [](exec::Executor& executor, exec::AddressLines lines,
             std::shared_ptr<const exec::ImageContent> image) {
            static_cast<HostExecutor&>(executor).prepare_for_confinement(std::move(lines), std::move(image));
          }};
}

/// Lets the program of `runner` run firmware of the other targets, too.
inline ExecutorFactory beside(ExecutorFactory runner, std::vector<ExecutorFactory> others) {
  runner.besides = std::move(others);
  return runner;
}

}  // namespace robosim::runner
