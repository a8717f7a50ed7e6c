// A test fixture that runs sketches on a host executor.
#pragma once

#include "sim/exec/host/host_executor.h"
#include "tests/support/sketch_test.h"

namespace robosim::exec {

class HostTest : public SketchTest {
 protected:
  HostTest() : SketchTest("host", "uno") {}
  std::unique_ptr<Executor> make_executor(const BoardSpec& board,
                                          const std::filesystem::path& image) override {
    auto host = std::make_unique<HostExecutor>(board, image);
    host->set_lateness(lateness_);
    host_ = host.get();
    return host;
  }

  std::vector<Lateness> lateness_;
  HostExecutor* host_ = nullptr;
};

}  // namespace robosim::exec
