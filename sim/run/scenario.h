// A scenario: what happens to the robot from outside, and when. The language is in docs/formats.md.
//
//   at 2s press start 100ms
//   after serial "Ready" send "3\n"
//   after station 3 place 2,2,E
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/board/sim_time.h"
#include "sim/base/error.h"

namespace robosim::run {

/// When a step is due. Each step happens once.
struct Trigger {
  enum class Kind {
    at,       ///< simulated time `time`
    serial,   ///< the firmware has sent `text`
    station,  ///< the station called `text` has been visited
  };
  Kind kind = Kind::at;
  SimTime time = 0;
  std::string text;
};

/// What then happens.
struct Action {
  enum class Verb { press, release, send, place, cover, fault, power };
  Verb verb = Verb::press;
  std::string part;  ///< press, release, cover, fault, send by radio; "off" or "on" for power
  std::vector<std::string> arguments;  ///< fault: kind and its arguments
  std::string text;                    ///< send: the bytes, or of a radio what was written; place: "X,Y,DIR"
  std::vector<bool> bits;              ///< send by radio
  std::optional<SimTime> duration;     ///< press, cover, power: undone after it
};

struct Step {
  Trigger trigger;
  Action action;
  Place place;  ///< where the script says so
};

/// Throws InputError with file and line, naming the triggers or verbs that exist. Names of parts and stations
/// are checked when the scenario meets a robot and a map.
std::vector<Step> parse_scenario(std::string_view text, const std::string& file);

}  // namespace robosim::run
