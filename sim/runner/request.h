// Requests of the runner protocol, read and checked.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>

#include "hal/board/sim_time.h"
#include "sim/robot/robot.h"

namespace robosim::runner {

struct RunRequest {
  std::string image, map, robot, start, goal;  ///< start and goal: empty = the map's
  SimTime limit = 0;
  std::uint64_t seed = 1;
  robot::Profile profile = robot::Profile::typical;
  std::string script;
  std::string script_file = "script";
  SimTime samples_every = 0;
  std::string counters;     ///< a file; empty = none
  SimTime clock_start = 0;  ///< of millis(); 0 = as it is
  int gdb_port = 0;         ///< where a debugger is waited for; 0 = nowhere
  bool stream_pins = false, stream_serial = false, stream_notes = false, stream_io = false;
  bool interactive = false;  ///< the client drives it step by step
  /// With `source`: events of pins and bytes are sent of this span only, and say where in the sketch they
  /// come from.
  std::optional<std::pair<SimTime, SimTime>> source;
};

/// Throws InputError for unknown keys and values of the wrong kind.
RunRequest parse_run_request(const nlohmann::json& json);

}  // namespace robosim::runner
