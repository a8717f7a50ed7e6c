// The targets that runner programs support.
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

/// Returns the factory for a target whose firmware is data, such as `avr` with `AvrExecutor`.
template <class Executor>
ExecutorFactory chip_target(const char* target) {
  return {target, [](const BoardSpec& board, const std::filesystem::path& image) {
            return std::make_unique<Executor>(board, image);
          }};
}

/// Lets the program of `runner` run firmware of the other targets, too.
inline ExecutorFactory beside(ExecutorFactory runner, std::vector<ExecutorFactory> others) {
  runner.besides = std::move(others);
  return runner;
}

}  // namespace robosim::runner
