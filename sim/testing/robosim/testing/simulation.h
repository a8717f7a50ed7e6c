// Simulates one robot with one sketch on one map, driven step by step.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "robosim/testing/drive.h"
#include "robosim/testing/events.h"
#include "robosim/testing/graph.h"
#include "robosim/testing/quantities.h"

namespace robosim::testing {

/// The run to simulate. Only the sketch has no default. Paths are relative to the current folder.
struct Trial {
  std::string sketch;  ///< a folder, an .ino, the name of one of Robosim's sketches, or a finished .elf
  std::string map;     ///< name, path, or the map itself (several lines); "" = the only map next to
                       ///< the sketch, else oval
  std::string robot;   ///< name, path, or a robot file's text; "" = robot.toml next to the sketch, else
                       ///< uno5 (bluepill5 for the target stm32)
  std::string target = "host";
  std::uint64_t seed = 1;
  std::string profile = "typical";         ///< or "ideal": no noise, no spread
  std::string start;                       ///< "X,Y,DIR"; "" = the map's start
  std::string goal = "none";               ///< the goal that ends the run; docs/reference/verdicts.md
  std::string script;                      ///< a scenario, from the beginning of the run
  Duration limit = std::chrono::hours(1);  ///< the run ends at this time at the latest
  Duration clock_start{};                  ///< initial value of millis(); chip targets only
  std::vector<std::string> libraries;      ///< folders of further Arduino libraries
  bool detect = true;                      ///< a detector's finding fails the test: docs/howto/sanitizers.md
};

class Simulation {
 public:
  /// Compiles the sketch and puts the robot on the map at time 0. Throws std::exception with a sentence if
  /// that is impossible: a wrong name, a sketch that does not compile, a missing tool.
  explicit Simulation(Trial trial);
  /// Ends the run. If the test has failed, saves files that help to understand the failure
  /// (docs/howto/testing.md).
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  // The next functions advance the time. A run that is lost, stuck, toppled, hung, over budget or crashed
  // fails the test when this object is destroyed. If the test has waited with ends(), or has called
  // verdict(), such a run does not fail the test.
  Drive run_for(Duration time, const char* file = __builtin_FILE(), int line = __builtin_LINE());
  [[nodiscard]] Drive run_until(const Event& event, Within<Duration> within,
                                const char* file = __builtin_FILE(), int line = __builtin_LINE());
  /// Runs to the verdict: the goal or the limit is reached, or the run fails.
  Drive run_to_the_end(const char* file = __builtin_FILE(), int line = __builtin_LINE());
  Duration now() const;

  // The next functions act immediately. They take the parts' names from the robot file. If a name is unknown,
  // they throw InputError with the place of the call, `file` and `at`.
  void press(const std::string& button, Duration time = 100_ms, const char* file = __builtin_FILE(),
             int at = __builtin_LINE());
  void hold(const std::string& button, const char* file = __builtin_FILE(), int at = __builtin_LINE());
  void release(const std::string& button, const char* file = __builtin_FILE(), int at = __builtin_LINE());
  /// Sends a text to the sketch over Serial.
  void send(const std::string& text, const char* file = __builtin_FILE(), int at = __builtin_LINE());
  void cover(const std::string& sensor, Duration time, const char* file = __builtin_FILE(),
             int at = __builtin_LINE());
  /// Puts the robot down, facing 'N', 'E', 'S' or 'W'.
  void place(int column, int row, char facing, const char* file = __builtin_FILE(),
             int at = __builtin_LINE());
  /// Lifts the robot and puts it down in place, facing the opposite direction (the nearest of N, E, S and W).
  void turn_round(const char* file = __builtin_FILE(), int at = __builtin_LINE());
  void power_off(Duration time = 100_ms, const char* file = __builtin_FILE(), int at = __builtin_LINE());
  /// Executes a line of the scenario language, without its time: "fault S2 stuck 1023".
  void act(const std::string& line, const char* file = __builtin_FILE(), int at = __builtin_LINE());

  // The next functions return the present state.
  Moment moment() const;
  Pose pose() const { return moment().pose; }
  /// Returns whether an LED or a button is on.
  bool is_on(const std::string& part, const char* file = __builtin_FILE(), int at = __builtin_LINE()) const;
  double reading(const std::string& part, const char* file = __builtin_FILE(),
                 int at = __builtin_LINE()) const;
  std::string station() const { return moment().station; }
  std::vector<std::string> stations_visited() const;  ///< in the order of the first visits
  std::string serial() const;                         ///< everything that the sketch has sent
  std::vector<std::uint8_t> eeprom() const;           ///< the board's whole EEPROM
  /// Returns the network of lines that is reachable from the robot's start. A sketch that explores the map
  /// must find this network.
  Graph true_graph() const;
  bool over() const;
  std::string verdict() const;  ///< "" until the run is over
  bool on_chip() const { return trial_.target != "host"; }

  /// Returns the whole run so far as a Drive.
  Drive so_far() const;
  operator Drive() const { return so_far(); }  // NOLINT(google-explicit-constructor)

  const Trial& trial() const { return trial_; }
  /// Returns the command that reproduces this run until now.
  std::string replay_command() const;
  /// Ends the run now, and returns its trace hash.
  std::string trace_hash();
  /// Ends the run now, and returns the number of bytes that the sketch has written to its EEPROM.
  std::uint64_t eeprom_writes();

 private:
  struct Impl;
  friend class Fleet;
  friend struct SharedRun;
  /// Makes one robot of a fleet.
  Simulation(Trial trial, std::unique_ptr<Impl> inside);

  Trial trial_;
  std::unique_ptr<Impl> impl_;
};

void PrintTo(const Simulation& simulation, std::ostream* out);

/// Returns the reason why a target cannot run: the missing tool and the remedy. Returns "" if nothing is
/// missing.
std::string what_lacks(const std::string& target);
/// Returns whether the environment variable ROBOSIM_REQUIRE, such as "host,avr", names the target.
bool is_required(const std::string& target);

}  // namespace robosim::testing

/// Ends the test, or SetUp, if a tool of the target is missing. The test fails if ROBOSIM_REQUIRE names the
/// target, and otherwise is skipped. Both messages state the remedy.
#define ROBOSIM_SKIP_WITHOUT(target)                                          \
  do {                                                                        \
    const std::string robosim_lacks = ::robosim::testing::what_lacks(target); \
    if (robosim_lacks.empty()) break;                                         \
    if (::robosim::testing::is_required(target)) FAIL() << robosim_lacks;     \
    GTEST_SKIP() << robosim_lacks;                                            \
  } while (false)
