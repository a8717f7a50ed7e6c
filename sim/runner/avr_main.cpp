// The runner of the target avr. It links libsimavr and is therefore, as a program, under the GPL-3
// (sim/exec/avr/simavr.h).
#include "sim/exec/avr/avr_executor.h"
#include "sim/runner/session.h"

int main() {
  return robosim::runner::serve(
      {"avr", [](const robosim::BoardSpec& board, const std::filesystem::path& image) {
         return std::make_unique<robosim::exec::AvrExecutor>(board, image);
       }});
}
