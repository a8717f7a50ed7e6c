// The runner of the target avr.
#include "sim/exec/avr/avr_executor.h"
#include "sim/runner/session.h"

int main() {
  return robosim::runner::serve(
      {"avr", [](const robosim::BoardSpec& board, const std::filesystem::path& image) {
         return std::make_unique<robosim::exec::AvrExecutor>(board, image);
       }});
}
