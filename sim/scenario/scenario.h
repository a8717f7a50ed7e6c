// A scenario: what happens to the robot from outside, and when. The language is described in
// docs/reference/scripts.md.
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
#include "sim/scenario/spread.h"

namespace robosim::scenario {

/// When a step is due. Each step happens once.
struct Trigger {
  enum class Kind {
    at,       ///< simulated time `time`
    serial,   ///< the firmware has sent `text`
    station,  ///< the station called `text` has been visited
    told,     ///< the part `part` has told a text that holds `text`
    boot,     ///< the chip has started for the `count`-th time; it does so first when the run begins
    eeprom,   ///< the firmware has begun to write its EEPROM for the `count`-th time
  };
  Kind kind = Kind::at;
  SimTime time = 0;  ///< at: when; else: so long after the event
  std::string text;
  std::string part;
  std::uint64_t count = 0;
};

/// What a byte of EEPROM holds when the power fails while it is written. The chip erases it first (all bits
/// set), then clears bits: it may hold anything.
struct HalfWritten {
  enum class Kind { done, before, value };
  Kind kind = Kind::done;  ///< done: the new content, for the supply lasts long enough; before: the old one
  std::uint8_t value = 0xFF;
};

constexpr double kObstacleRadius = 0.033;  ///< m: a drinks can of 330 ml

/// What then happens.
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
  std::string part;  ///< press, release, cover, fault, send to a part; "off" or "on" for power and light;
                     ///< "shut" or "open" for a door
  std::vector<std::string> arguments;  ///< fault: kind and its arguments
  std::string text;  ///< send: the bytes, or what a part is sent; place: "X,Y,DIR"; obstacle, clear:
                     ///< "X,Y"; paint, erase, door: "X,Y X,Y"; light: its number, or "all"
  std::string to;    ///< obstacle: the cell that it moves to; empty = it stays
  SimTime held = 0;  ///< send: for which a remote control's key is held
  double radius = kObstacleRadius;  ///< m, of an obstacle
  double reach = 0.0;               ///< m, of sweep: so far to each side
  SimTime period = 0;  ///< of sweep: to and fro; of tilt: the way over, or back; of obstacle: the way to `to`
  double angle = 0.0;  ///< rad, of tilt: so far …
  Vec2 side;           ///< … to where, in the robot's frame
  HalfWritten half_written;         ///< power off
  std::optional<SimTime> duration;  ///< undone after it; of press, lift, cover, obstacle, fault, power
};

/// What an action is about, where a later one about the same makes the end of this one void; else empty.
std::string subject_of(const Action& action);
/// What a finger is on that presses or covers: it stays until the last finger has left; else empty.
std::string finger_of(const Action& action);

struct Step {
  Trigger trigger;
  Action action;
  Place place;           ///< where the script says so
  std::string varies{};  ///< the line, if it has figures with a spread (spread.h), which are here as written
};

/// One line; nothing if it is empty or a comment. Throws as parse_scenario does.
std::optional<Step> parse_step(std::string_view line, const Place& place);
/// A line that varies, with such shares of its spreads.
Step parse_varied(const Step& step, const Share& share);

/// Throws InputError with file and line, naming the triggers or verbs that exist. Names of parts and stations
/// are checked when the scenario meets a robot and a map.
std::vector<Step> parse_scenario(std::string_view text, const std::string& file);

}  // namespace robosim::scenario
