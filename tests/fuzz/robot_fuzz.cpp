// Reads arbitrary bytes as a robot file. Either the file is rejected with a message, or it describes a robot
// whose body can be simulated.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "sim/robot/describe.h"
#include "sim/robot/description.h"
#include "sim/world/body.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace robosim;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const robot::Description description = robot::parse_description(text, "fuzzed/robot.toml");
    robot::describe(description);
    const world::Body body(robot::body_params(description, 1, robot::Profile::typical), Pose{});
  } catch (const InputError&) {
  }
  return 0;
}
