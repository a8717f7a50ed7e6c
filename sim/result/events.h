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
  v("station", e.station, "`station_visited`: name of the station");
}

/// A lap of a loop is complete.
struct LapDone {
  static constexpr const char* kKind = "lap_done";
  int lap = 0;         ///< from 1; each direction has its own count
  double lap_s = 0.0;  ///< duration of the lap
};

template <class V>
void fields(V& v, Same<V, LapDone>& e) {
  v("lap", e.lap, "`lap_done`: number of the lap, from 1, in its direction");
  v("lap_s", e.lap_s, "`lap_done`: duration of the lap", {.unit = "s"});
}

/// The body has collided with something.
struct CollisionBegan {
  static constexpr const char* kKind = "collision_began";
  bool with_robot = false;  ///< otherwise with a wall, an obstacle or the map's edge
};

template <class V>
void fields(V& v, Same<V, CollisionBegan>& e) {
  v("with_robot", e.with_robot,
    "`collision_began`: `true`: with another robot; `false`: with a wall, an obstacle or the map's edge");
}

/// The script acted, or an action of limited duration ended. For example, a lifted robot was put down.
struct ScriptActed {
  static constexpr const char* kKind = "script_acted";
  std::string verb;  ///< a verb of the scenario language: press, release, send, place, lift, lower, tilt,
                     ///< sweep, cover, uncover, obstacle, clear, paint, erase, door, light, restore
  /// For press, release, cover, uncover and send: the part. For light: "on" or "off". For door: "shut" or
  /// "open". For restore: the restored state of the light or door. Otherwise empty.
  std::string part;
  /// For send: the bytes. For place: "X,Y,DIR". For obstacle and clear: "X,Y". For paint, erase and door:
  /// "X,Y X,Y". For light: its number or "all". For restore: the text of the action that ended.
  std::string text;
  std::array<double, 3> disc_mm{};  ///< for obstacle: x and y of its centre, and its radius
  std::array<double, 3>
      moves{};  ///< for obstacle: x and y of its target in mm, and the duration in seconds; 0 s = no move
  std::array<double, 4>
      box_mm{};  ///< for paint, erase, door, and restore after them: left, bottom, width, height of the area
};

template <class V>
void fields(V& v, Same<V, ScriptActed>& e) {
  v("verb", e.verb, "`script_acted`: verb of the scenario language: `\"press\"`, `\"send\"`, `\"place\"` …");
  v("part", e.part,
    "`script_acted`: the part, for press, release, cover, uncover, and for send to a part; `\"on\"` or "
    "`\"off\"` for light, `\"shut\"` or `\"open\"` for door; for restore, the restored state; else empty");
  v("argument", e.text,
    "`script_acted`: argument of send, place, obstacle, clear, paint, erase, door, light or restore; else "
    "empty");
  v("disc", e.disc_mm, "`script_acted`: for obstacle, x and y of its centre, and its radius",
    {.unit = "mm", .presence = when(e.disc_mm[2] > 0.0)});
  v("moves", e.moves,
    "`script_acted`: for an obstacle that moves, x and y of its target (mm), and the duration in seconds",
    {.presence = when(e.moves[2] > 0.0)});
  v("box", e.box_mm,
    "`script_acted`: for paint, erase, door, and restore of these: left, bottom, width and height of the "
    "changed area",
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
  v("resets_chip", e.resets_chip,
    "`fault_began`: whether the supply voltage has become too low for the chip");
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
  v("part", e.part, "`fault_ended`: the part, as for `fault_began`");
  v("arguments", e.arguments, "`fault_ended`: arguments of the fault; `[\"ok\"]` if the script ended it");
  v("repaired", e.repaired,
    "`fault_ended`: `true`: the script ended the fault; `false`: its duration was over");
}

/// The board has lost power: the script switched it off, or the supply voltage became too low.
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
  v("value", b.value, "present value of the byte");
}

template <class V>
void fields(V& v, Same<V, PowerLost>& e) {
  v("byte", e.byte, "`power_lost`: the EEPROM byte whose write was interrupted; absent if there was none");
}

/// The board has power again, and the firmware restarts.
struct PowerBack {
  static constexpr const char* kKind = "power_back";
};

template <class V>
void fields(V&, Same<V, PowerBack>&) {}

/// A part displays or sends text for people: a display, a Bluetooth module.
struct PartTold {
  static constexpr const char* kKind = "part_told";
  std::string part;
  std::string text;  ///< a line that the sketch sent through the part, or the displayed lines joined by "|"
};

template <class V>
void fields(V& v, Same<V, PartTold>& e) {
  v("part", e.part, "`part_told`: name of a display, a Bluetooth module …");
  v("shows", e.text,
    "`part_told`: the displayed lines, joined by `|`, or a line that the sketch has sent through the part");
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
  v("what", e.what, "`scored`: reason for the score, for people: `\"gap\"`");
  v("value", e.value, "`scored`: value of the score");
  v("score_unit", e.unit, "`scored`: unit of the value: `\"s\"` or `\"points\"`");
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
