// What a runner is asked, and what it says: docs/runner-protocol.md as C++ values.
//
// Times are simulated. Lengths are millimetres, angles radians; world coordinates have x east and y north,
// with the origin at the map's bottom-left corner.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace robosim::wire {

/// Who answers at the other end of the pipe.
struct Hello {
  std::string program;  ///< "robosim-host"
  int protocol = 0;
  std::string version;  ///< of Robosim: "0.1.0"
  std::string target;   ///< "host"
};

/// A robot as a client may see it.
struct RobotInfo {
  struct Board {
    std::string name;   ///< "uno"
    std::string fqbn;   ///< "arduino:avr:uno"
    std::string macro;  ///< "ARDUINO_AVR_UNO"
  };
  /// What firmware may take of the chip, at most; 0 = all there is.
  struct Budget {
    std::int64_t flash_bytes = 0;
    std::int64_t ram_bytes = 0;
  };
  struct Sensor {
    std::string name;
    double x_mm = 0.0;  ///< forward of the axle's centre
    double y_mm = 0.0;  ///< left of it
  };
  struct Part {
    std::string name;
    std::string type;  ///< "motor"
    std::vector<std::pair<std::string, std::string>>
        pins;  ///< what the pin is for, and the pin: {"in1", "8"}
  };
  std::string name;
  std::string file;
  std::string sha256;
  Board board;
  Budget budget;
  std::vector<std::array<double, 2>> outline_mm;  ///< corners in the body's frame: forward, left
  std::vector<Sensor> sensors;
  std::vector<Part> parts;
};

/// One simulation.
struct RunRequest {
  std::string image;                      ///< path of the firmware image
  std::string map;                        ///< path
  std::string robot;                      ///< name or path
  std::string start;                      ///< "X,Y,DIR"; empty = the map's
  std::string goal;                       ///< empty = the map's
  std::int64_t for_ns = 600'000'000'000;  ///< simulated time
  std::uint64_t seed = 1;
  std::string profile = "typical";     ///< or "ideal"
  std::int64_t clock_ns = 0;           ///< what millis() begins with; chip targets only
  int gdb_port = 0;                    ///< where the run waits for a debugger; 0 = nowhere; chip targets only
  std::string script;                  ///< text of a scenario
  std::string script_file = "script";  ///< its name in messages
  std::int64_t samples_every_ns = 0;   ///< a multiple of 1 ms; 0 = no samples
  bool pins = false;                   ///< stream pin changes
  bool serial = false;                 ///< stream what the firmware prints
  bool notes = false;                  ///< stream what happens: "station 2 visited"
  bool io = false;                     ///< stream what reaches the firmware, and bytes both ways
  /// Of pins and bytes, stream only what happens from the one time to the other, and from which line of the
  /// sketch.
  std::optional<std::pair<std::int64_t, std::int64_t>> source_ns;
  bool interactive = false;  ///< driven step by step: see driven_run.h
  std::string counters;      ///< file for what an image built for coverage has counted; empty = none
};

/// Sent once, before everything else.
struct Started {
  struct Station {
    int id = 0;
    std::string name;
    int x = 0;  ///< column, from the left
    int y = 0;  ///< row, from the top
  };
  int x = 0;  ///< start: column
  int y = 0;  ///< start: row
  char facing = 'E';
  std::string goal;
  std::vector<Station> stations;
  std::vector<std::string> readings;  ///< names of Sample::readings
  int width = 0;                      ///< of the map, in cells
  int height = 0;
  double cell_mm = 0.0;  ///< side of a cell
};

struct Sample {
  std::int64_t t_us = 0;
  double x_mm = 0.0;
  double y_mm = 0.0;
  double yaw_rad = 0.0;
  double speed_mm_s = 0.0;
  double cross_track_mm = 0.0;
  double left = 0.0;             ///< command of the left motor, -1..1
  double right = 0.0;            ///< command of the right motor, -1..1
  std::vector<double> readings;  ///< sensors: 0 white .. 1 black; LEDs and buttons: 0 or 1
  std::string at_station;        ///< of a driven run: whose centre the body covers; "" = none
};

/// A line of the sketch; "" and 0 where not known, or not asked for.
struct Source {
  std::string function;
  std::string file;
  int line = 0;
};

struct PinChange {
  std::int64_t t_ns = 0;
  std::string pin;   ///< "D5"
  std::string mode;  ///< "input", "input_pullup" or "output"
  bool level = false;
  bool pwm = false;
  double duty = 0.0;
  std::uint32_t tone_hz = 0;  ///< 0 = none
  Source source;
};

/// The firmware looked at a pin, or an edge reached one of its interrupts.
struct LevelSeen {
  std::int64_t t_ns = 0;
  std::string pin;
  bool level = false;
  Source source;
};

/// The ADC sampled a pin.
struct VoltsSeen {
  std::int64_t t_ns = 0;
  std::string pin;
  double volts = 0.0;
  Source source;
};

/// A byte at the UART.
struct SerialByte {
  std::int64_t t_ns = 0;
  std::uint8_t value = 0;
  bool sent = false;  ///< by the firmware; else received
  Source source;
};

struct SerialText {
  std::int64_t t_ns = 0;
  std::string text;
};

struct Note {
  std::int64_t t_ns = 0;
  std::string text;
};

/// The run waits for a debugger before the firmware's first instruction.
struct DebuggerAwaited {
  int port = 0;
};

using Event = std::variant<Started, Sample, PinChange, SerialText, Note, LevelSeen, VoltsSeen, SerialByte,
                           DebuggerAwaited>;
/// Called for every event, in the order of simulated time (of LevelSeen and SerialByte nearly so). While it
/// does not return, the runner is held up by the full pipe; no result depends on that.
using OnEvent = std::function<void(const Event&)>;

/// Figures of a run; docs/formats.md says how each is measured.
struct Metrics {
  double distance_m = 0.0;
  std::vector<double> laps_s;
  double cross_track_rms_mm = 0.0;
  double cross_track_max_mm = 0.0;
  double off_line_s = 0.0;
  int collisions = 0;
  double energy_j = 0.0;
  std::vector<std::string> stations;  ///< visited ones, by name, in the order of the first visit
  int junctions = 0;
};

/// Where and why the firmware crashed; empty and 0 where not known.
struct Crash {
  std::string reason;
  std::string function;
  std::string file;
  int line = 0;
  struct Call {
    std::string function;
    std::string file;
    int line = 0;
  };
  std::vector<Call> calls;  ///< on a chip: innermost first, the core's included
  std::string registers;    ///< on a chip: of its processor, lines for people
  std::string check;        ///< of --sanitize, if one has found it: "mul_overflow"; else empty
};

/// What the firmware took of its chip; docs/formats.md says how each is measured.
struct Resources {
  std::int64_t flash_bytes = 0;
  std::int64_t ram_bytes = 0;
  std::int64_t stack_bytes_max = 0;
  std::int64_t loops = 0;  ///< 0 = loop() was not found or ran once; the next two are then 0
  double loop_us_max = 0.0;
  double loop_us_mean = 0.0;
  double interrupt_share = 0.0;
  double cpu_load = 0.0;
};

struct RunResult {
  struct Entry {
    double t_s = 0.0;
    std::string text;
  };
  std::string verdict;  ///< "reached", "lost", …
  std::string why;      ///< one sentence
  std::string next;     ///< what to try next; may be empty
  int status = 0;       ///< exit status that belongs to the verdict
  double time_s = 0.0;
  std::string goal;
  double for_s = 0.0;
  std::uint64_t seed = 1;
  std::string profile;
  Metrics metrics;
  std::optional<Crash> crash;
  std::optional<Resources> resources;  ///< on a chip
  std::vector<Entry> events;           ///< the last ones
  std::string serial;
  double end_x_mm = 0.0;  ///< where the robot is
  double end_y_mm = 0.0;
  double end_yaw_rad = 0.0;
  std::uint64_t eeprom_writes = 0;  ///< bytes that the firmware wrote to its EEPROM
  std::string trace_hash;
  std::string map_sha256;
  std::string robot_sha256;
  std::string image_sha256;
};

/// What a run that is driven step by step goes on until; docs/runner-protocol.md lists them.
struct Stop {
  enum class Kind { serial, line, note, visited, at, reading, pin, motors, rest };
  Kind kind = Kind::rest;
  std::string text;          ///< text, regular expression, station, part or pin
  std::size_t from = 0;      ///< serial, line: number of the first byte that counts
  bool level = true;         ///< reading, pin, motors
  std::int64_t rest_ns = 0;  ///< rest

  static Stop serial(std::string text, std::size_t from = 0) { return {Kind::serial, std::move(text), from}; }
  static Stop line(std::string regex, std::size_t from = 0) { return {Kind::line, std::move(regex), from}; }
  static Stop note(std::string text) { return {Kind::note, std::move(text)}; }
  static Stop visited(std::string station) { return {Kind::visited, std::move(station)}; }
  static Stop at(std::string station) { return {Kind::at, std::move(station)}; }
  static Stop reading(std::string part, bool on) { return {Kind::reading, std::move(part), 0, on}; }
  static Stop pin(std::string pin, bool high) { return {Kind::pin, std::move(pin), 0, high}; }
  static Stop motors(bool driven) { return {Kind::motors, "", 0, driven}; }
  static Stop rest(std::int64_t ns) { return {Kind::rest, "", 0, true, ns}; }
};

/// The state of a run that stands still, at the beginning of a tick.
struct Paused {
  std::int64_t t_ns = 0;
  Sample sample;
  int stop = -1;  ///< which of the stops was met; -1 = none
  /// Since it went on last: when and where the cross-track error was the largest. Every tick counts.
  double worst_cross_track_mm = 0.0;
  std::int64_t worst_t_ns = 0;
  double worst_x_mm = 0.0;
  double worst_y_mm = 0.0;
  bool powered = true;
  bool driven = false;           ///< a motor is commanded
  std::size_t serial_bytes = 0;  ///< sent by the firmware so far
  Metrics metrics;
  std::optional<Resources> resources;  ///< on a chip
};

/// Lines that a run that stands still will carry out, with their times.
struct Accepted {
  std::string lines;
};
/// Its non-volatile memory.
struct Eeprom {
  std::vector<std::uint8_t> bytes;
};
/// What it was asked makes no sense: nothing happened.
struct Refused {
  std::string message;
};

}  // namespace robosim::wire
