// What happens in a run, as values. Whoever needs to know what happened compares values; text_of() is the one
// place where they become sentences, so a sketch that prints "collision" is not one.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace robosim::wire {

/// The body's outline has covered a station's centre for the first time.
struct StationVisited {
  std::string station;  ///< its name
};

/// A lap of a loop is complete.
struct LapDone {
  int lap = 0;         ///< from 1; each direction counts its own
  double lap_s = 0.0;  ///< how long it took
};

/// The body has come up against something.
struct CollisionBegan {
  bool with_robot = false;  ///< else a wall, an obstacle or the map's edge
};

/// The script did something, or what it did for a while is over: a lifted robot is put down, an obstacle
/// taken away.
struct ScriptActed {
  std::string
      verb;  ///< the scenario language's: press, release, send, place, lift, lower, cover, obstacle, clear
  std::string part;  ///< press, release, cover, and send to a radio; else empty
  std::string text;  ///< send: what; place: "X,Y,DIR"; obstacle, clear: "X,Y"
};

/// The script broke something.
struct FaultBegan {
  std::string part;                    ///< a part of the robot, or power, serial, eeprom, clock
  std::vector<std::string> arguments;  ///< the kind of fault, then its arguments: {"stuck", "1023"}
  bool resets_chip = false;            ///< the supply no longer suffices for the chip
};

/// It is whole again: its time was up, or the script repaired it.
struct FaultEnded {
  std::string part;
  std::vector<std::string> arguments;  ///< of the fault; {"ok"} where the script said so
};

/// The script switched the board off.
struct PowerLost {
  /// A byte of EEPROM that was being written, and what it holds now.
  struct HalfWritten {
    int address = 0;
    int value = 0;
  };
  std::optional<HalfWritten> byte;
};

/// The script switched it on, or the time that it was off is up: the firmware starts afresh.
struct PowerBack {};

/// One of these, with its simulated time and the robot that it is about.
struct RunEvent {
  using What = std::variant<StationVisited, LapDone, CollisionBegan, ScriptActed, FaultBegan, FaultEnded,
                            PowerLost, PowerBack>;
  std::int64_t t_ns = 0;
  int agent = 0;  ///< number of the robot, from 0
  What what;
};

/// "station_visited", "lap_done", "collision_began", "script_acted", "fault_began", "fault_ended",
/// "power_lost" or "power_back".
const char* kind_of(const RunEvent& event);
/// The names that kind_of() gives.
const std::vector<std::string>& event_kinds();

/// "station 2 visited", "lap 1 in 8.54 s", "fault: S2 stuck 1023" …
std::string text_of(const RunEvent& event);

}  // namespace robosim::wire
