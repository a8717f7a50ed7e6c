// Defines scenarios, which are lists of stimuli to the robot and their times. docs/reference/scripts.md
// describes the language.
//
//   at 2s press start 100ms
//   after serial "Ready" send "3\n"
//   after station 3 wait 500ms place 2,2,E
//   at 5s fault S2 stuck 1023 for 500ms
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/board/sim_time.h"
#include "sim/base/error.h"
#include "sim/base/vec.h"
#include "sim/run/scenario/spread.h"

namespace robosim::scenario {

/// The time or event at which a step is due. Each step runs once.
struct Trigger {
  enum class Kind {
    at,       ///< simulated time `time`
    serial,   ///< the firmware has sent `text`
    station,  ///< the station called `text` has been visited
    told,     ///< the part `part` has shown a text that contains `text`
    boot,     ///< the chip has started for the `count`-th time; the run begins with the first start
    eeprom,   ///< the firmware has begun to write its EEPROM for the `count`-th time
  };
  Kind kind = Kind::at;
  SimTime time = 0;  ///< for `at`: the time; otherwise: the delay after the event
  std::string text;
  std::string part;
  std::uint64_t count = 0;
};

/// The value of an EEPROM byte after a power failure during its write. The chip erases the byte first (all
/// bits set), then clears bits, so that the byte may have any value.
struct HalfWritten {
  enum class Kind { done, before, value };
  Kind kind = Kind::done;  ///< done: the write finishes, with the new content; before: the old content
  std::uint8_t value = 0xFF;
};

constexpr double kObstacleRadius = 0.033;  ///< m, the radius of a drinks can of 330 ml

/// The action of a step.
struct Action {
  enum class Verb {
    press,
    release,
    send,
    place,
    lift,
    lower,
    cover,
    obstacle,
    clear,
    fault,
    power,
    sweep,
    tilt,
    paint,
    erase,
    door,
    light
  };
  Verb verb = Verb::press;
  /// For press, release, cover, fault and send: the part. For power and light: "off" or "on". For door:
  /// "shut" or "open".
  std::string part;
  std::vector<std::string> arguments;  ///< for fault: the kind and its arguments
  /// For send: the bytes, or the message to a part. For place: "X,Y,DIR". For obstacle and clear: "X,Y". For
  /// paint, erase and door: "X,Y X,Y". For light: its number, or "all".
  std::string text;
  std::string to;                   ///< for obstacle: the cell to which the obstacle moves; empty = no move
  SimTime held = 0;                 ///< for send to a remote control: how long its key is held down
  double radius = kObstacleRadius;  ///< in metres; for obstacle: its radius
  double reach = 0.0;               ///< in metres; for sweep: the distance to each side
  SimTime period = 0;        ///< duration of a sweep's cycle, of tilting, or of an obstacle's move to `to`
  double angle = 0.0;        ///< rad, for tilt: the angle
  Vec2 side;                 ///< for tilt: the side that goes down, a unit vector in the robot's frame
  HalfWritten half_written;  ///< for power off: the EEPROM byte that is being written
  std::optional<SimTime> duration;  ///< the action is undone after this time; empty = never
};

/// Returns the object that an action changes, such as "body" or "fault S2"; empty for other actions. A later
/// action on the same object cancels the scheduled end of this action.
std::string subject_of(const Action& action);
/// Returns the verb and the part if an action presses or covers a part with a finger; empty for other
/// actions. The part stays pressed or covered until the last finger leaves.
std::string finger_of(const Action& action);

struct Step {
  Trigger trigger;
  Action action;
  Place place;           ///< position in the script
  std::string varies{};  ///< the line, if it has spreads (spread.h); the step itself has the nominal values
};

/// Parses one line. Returns nullopt if the line is empty or a comment. Throws the same errors as
/// parse_scenario().
std::optional<Step> parse_step(std::string_view line, const Place& place);
/// Returns a step with values inside their spreads. `share` gives the position of each value in its spread.
Step parse_varied(const Step& step, const Share& share);

/// Parses a scenario. Throws InputError with file and line, and the valid triggers or verbs. Names of parts
/// and stations are checked later, with a robot and a map.
std::vector<Step> parse_scenario(std::string_view text, const std::string& file);

}  // namespace robosim::scenario
