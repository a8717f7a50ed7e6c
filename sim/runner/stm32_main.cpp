// The runner of the target stm32. It links libunicorn and is therefore, as a program, under the GPL-2
// (sim/exec/stm32/unicorn.h).
#include "sim/exec/stm32/stm32_executor.h"
#include "sim/runner/session.h"

int main() {
  return robosim::runner::serve(
      {"stm32", [](const robosim::BoardSpec& board, const std::filesystem::path& image) {
         return std::make_unique<robosim::exec::Stm32Executor>(board, image);
       }});
}
