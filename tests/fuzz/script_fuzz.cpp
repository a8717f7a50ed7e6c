// Reads arbitrary bytes as a script. Either the script is rejected with a message that names the line, or
// each of its steps is one line.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "sim/run/scenario/scenario.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace robosim;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto lines = std::count(text.begin(), text.end(), '\n') + 1;
  try {
    const auto steps = scenario::parse_scenario(text, "fuzz.txt");
    require(steps.size() <= static_cast<std::size_t>(lines), "a step is a line");
    int last = 0;
    for (const scenario::Step& step : steps) {
      require(step.place.line > last && step.place.line <= lines, "steps are in the order of their lines");
      require(step.trigger.time >= 0 && step.action.duration.value_or(0) >= 0, "no time is negative");
      last = step.place.line;
    }
  } catch (const InputError& error) {
    require(error.place().line >= 1 && error.place().line <= lines, "errors name the line");
    require(!error.message().empty(), "errors say something");
  }
  return 0;
}
