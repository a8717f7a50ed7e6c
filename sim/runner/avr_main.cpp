// The runner of the target avr. It links libsimavr and is therefore, as a program, under the GPL-3
// (sim/executors/avr/simavr.h).
#include "sim/executors/avr_executor.h"
#include "sim/runner/session.h"

int main() {
  return robosim::runner::serve(
      {"avr", [](const robosim::BoardSpec& board, const std::filesystem::path& image) {
         return std::make_unique<robosim::executors::AvrExecutor>(board, image);
       }});
}
