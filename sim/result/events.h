// Defines the events of a run as structs. Programs compare the structs; only text_of() converts them to
// sentences. Text that a sketch prints, such as "collision", is therefore never mistaken for an event.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sim/result/fields.h"

namespace robosim::result {

/// The body's outline has covered a station's centre for the first time.
struct StationVisited {
  static constexpr const char* kKind = "station_visited";
  std::string station;  ///< the station's name
};

template <class V>
void fields(V& v, Same<V, StationVisited>& e) {
  v("station", e.station, "`station_visited`: its name");
}

/// A lap of a loop is complete.
struct LapDone {
  static constexpr const char* kKind = "lap_done";
  int lap = 0;         ///< from 1; each direction has its own count
  double lap_s = 0.0;  ///< duration of the lap
};

template <class V>
void fields(V& v, Same<V, LapDone>& e) {
  v("lap", e.lap, "`lap_done`: its number from 1; each direction counts its own");
  v("lap_s", e.lap_s, "`lap_done`: how long it took", {.unit = "s"});
}

/// The body has collided with something.
struct CollisionBegan {
  static constexpr const char* kKind = "collision_began";
  bool with_robot = false;  ///< otherwise with a wall, an obstacle or the map's edge
};

template <class V>
void fields(V& v, Same<V, CollisionBegan>& e) {
  v("with_robot", e.with_robot,
    "`collision_began`: with another robot; else with a wall, an obstacle or the map's edge");
}

/// The script acted, or an action of limited duration ended: a lifted robot is put down, an obstacle removed.
struct ScriptActed {
  static constexpr const char* kKind = "script_acted";
  std::string verb;  ///< a verb of the scenario language: press, release, send, place, lift, lower, tilt,
                     ///< sweep, cover, uncover, obstacle, clear, paint, erase, door, light, restore
  std::string part;  ///< press, release, cover, uncover, send: the part; light: on, off; door: shut, open
  std::string text;  ///< send: the bytes; place: "X,Y,DIR"; obstacle, clear: "X,Y"; paint, erase, door:
                     ///< "X,Y X,Y"; light: its number or "all"
  std::array<double, 3> disc_mm{};  ///< obstacle: x and y of its centre, and its radius
  std::array<double, 3>
      moves{};  ///< obstacle: its target x and y, mm, and the duration in seconds; 0 s = it does not move
  std::array<double, 4> box_mm{};  ///< paint, erase, door: left, bottom, width, height of the area
};

template <class V>
void fields(V& v, Same<V, ScriptActed>& e) {
  v("verb", e.verb, "`script_acted`: the scenario language's: `\"press\"`, `\"send\"`, `\"place\"` …");
  v("part", e.part,
    "`script_acted`: of press, release, cover, uncover, and send to a part; of light on or off, of door shut "
    "or open; "
    "else empty");
  v("argument", e.text,
    "`script_acted`: of send, place, obstacle, clear, paint, erase, door and light; else empty");
  v("disc", e.disc_mm, "`script_acted`: of obstacle: x and y of its centre, and its radius",
    {.unit = "mm", .presence = when(e.disc_mm[2] > 0.0)});
  v("moves", e.moves,
    "`script_acted`: of an obstacle that moves: to which x and y (mm), and how many seconds it takes",
    {.presence = when(e.moves[2] > 0.0)});
  v("box", e.box_mm,
    "`script_acted`: of paint, erase and door: the rectangle of the floor that it covers: left, bottom, "
    "width "
    "and height",
    {.unit = "mm", .presence = when(e.box_mm[2] > 0.0)});
}

/// The script has injected a fault.
struct FaultBegan {
  static constexpr const char* kKind = "fault_began";
  std::string part;                    ///< a part of the robot, or power, serial, eeprom, clock
  std::vector<std::string> arguments;  ///< the kind of fault, then its arguments: {"stuck", "1023"}
  bool resets_chip = false;            ///< the supply voltage has become too low for the chip
};

template <class V>
void fields(V& v, Same<V, FaultBegan>& e) {
  v("part", e.part,
    "`fault_began`: a part of the robot, or `\"power\"`, `\"serial\"`, `\"eeprom\"`, `\"clock\"`");
  v("arguments", e.arguments, "`fault_began`: the kind of fault, then its arguments");
  v("resets_chip", e.resets_chip, "`fault_began`: the supply no longer suffices for the chip");
}

/// A fault has ended: its duration was over, or the script repaired it.
struct FaultEnded {
  static constexpr const char* kKind = "fault_ended";
  std::string part;
  std::vector<std::string> arguments;  ///< the fault's arguments; {"ok"} if the script ended it
  bool repaired = false;               ///< the script repaired it; otherwise its duration was over
};

template <class V>
void fields(V& v, Same<V, FaultEnded>& e) {
  v("part", e.part, "`fault_ended`: as above");
  v("arguments", e.arguments, "`fault_ended`: of the fault; `[\"ok\"]` where the script said so");
  v("repaired", e.repaired, "`fault_ended`: the script said so; else the fault's time was up");
}

/// The script switched the board off.
struct PowerLost {
  static constexpr const char* kKind = "power_lost";
  /// A byte of EEPROM whose write was interrupted, and its present value.
  struct HalfWritten {
    int address = 0;
    int value = 0;
  };
  std::optional<HalfWritten> byte;
};

template <class V>
void fields(V& v, Same<V, PowerLost::HalfWritten>& b) {
  v("address", b.address, "address of the byte");
  v("value", b.value, "its present value");
}

template <class V>
void fields(V& v, Same<V, PowerLost>& e) {
  v("byte", e.byte, "`power_lost`: the byte of EEPROM that was being written; absent if none was");
}

/// The script switched the board on, or the power cut ended: the firmware restarts.
struct PowerBack {
  static constexpr const char* kKind = "power_back";
};

template <class V>
void fields(V&, Same<V, PowerBack>&) {}

/// A part displays or sends text for people: a display, a Bluetooth module.
struct PartTold {
  static constexpr const char* kKind = "part_told";
  std::string part;
  std::string text;  ///< a received line, or the displayed lines joined by "|"
};

template <class V>
void fields(V& v, Same<V, PartTold>& e) {
  v("part", e.part, "`part_told`: a display, a Bluetooth module …");
  v("shows", e.text,
    "`part_told`: what it shows, lines joined by `|`, or a line that the sketch has sent through it");
}

/// A score under the rules of a competition.
struct Scored {
  static constexpr const char* kKind = "scored";
  std::string what;    ///< the reason for the score: "gap", "try 1, 24.31 s"
  double value = 0.0;  ///< value of the score
  std::string unit;    ///< "s" or "points"
};

template <class V>
void fields(V& v, Same<V, Scored>& e) {
  v("what", e.what, "`scored`: for people: `\"gap\"`");
  v("value", e.value, "`scored`: what it counts");
  v("score_unit", e.unit, "`scored`: `\"s\"` or `\"points\"`");
}

/// An event with its simulated time and its robot.
struct RunEvent {
  using What = std::variant<StationVisited, LapDone, CollisionBegan, ScriptActed, FaultBegan, FaultEnded,
                            PowerLost, PowerBack, PartTold, Scored>;
  std::int64_t t_ns = 0;
  int agent = 0;  ///< number of the robot, from 0
  What what;
};

/// Returns "station_visited", "lap_done", "collision_began", "script_acted", "fault_began", "fault_ended",
/// "power_lost", "power_back", "part_told" or "scored".
const char* kind_of(const RunEvent& event);
/// Returns all results of kind_of().
const std::vector<std::string>& event_kinds();

/// Returns "station 2 visited", "lap 1 in 8.54 s", "fault: S2 stuck 1023" …
std::string text_of(const RunEvent& event);

}  // namespace robosim::result
