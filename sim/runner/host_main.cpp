#include "sim/exec/host/host_executor.h"
#include "sim/runner/session.h"

int main() {
  using robosim::exec::HostExecutor;
  return robosim::runner::serve({"host",
                                 [](const robosim::BoardSpec& board, const std::filesystem::path& image) {
                                   return std::make_unique<HostExecutor>(board, image);
                                 },
                                 [](robosim::exec::Executor& executor, robosim::exec::AddressLines lines) {
                                   static_cast<HostExecutor&>(executor).prepare_for_confinement(
                                       std::move(lines));
                                 }});
}
