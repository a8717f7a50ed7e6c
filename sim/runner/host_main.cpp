#include "sim/exec/host/host_executor.h"
#include "sim/runner/session.h"

int main() {
  return robosim::runner::serve(
      {"host", [](const robosim::BoardSpec& board, const std::filesystem::path& image) {
         return std::make_unique<robosim::exec::HostExecutor>(board, image);
       }});
}
