// Prepares several robots on one map. Makes one request from the names that the user typed for all robots. A
// fleet file has a table for each robot:
//
//   [[agent]]
//   name = "A"
//   sketch = "PidFollower"
//   start = "10,14,E"
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/error.h"
#include "sim/launch/launch.h"

namespace robosim::launch {

/// A robot of the fleet.
struct Member {
  std::string name;
  Launch launch;  ///< the script's text is in the request; the map is ignored
  Place place;    ///< position of the table in the fleet file, for messages
};

struct Fleet {
  std::vector<Member> members;  ///< in the order of their numbers
  std::string map;              ///< empty = not given
  std::string file;             ///< empty = none

  Member* find(const std::string& name);
};

/// Returns whether a sketch argument names a fleet file.
bool is_fleet_file(const std::string& word);
/// Reads a fleet file. Throws InputError.
Fleet read_fleet(const std::filesystem::path& file);
Fleet parse_fleet(std::string_view text, const std::filesystem::path& file);
/// Throws InputError if `name` cannot be the name of a robot.
void check_member_name(const std::string& name, const Place& place = {});

/// Returns the target whose runner can run firmware of all these targets.
std::string runner_of(const std::vector<std::string>& targets);

/// A fleet whose files are chosen. Its sketches have not been compiled yet.
struct ChosenFleet {
  std::vector<Chosen> members;
  std::string runner;  ///< target of the runner for all robots
};
/// Chooses the files of each robot. Throws InputError with the robot's name.
ChosenFleet choose(Fleet& fleet);

struct PreparedFleet {
  std::vector<Prepared> members;
  wire::RunRequest request;  ///< request for all robots
};
/// Prepares a fleet. `common` contains the settings for all robots. Each member's request adds start, goal,
/// clock and script. Throws the exceptions of Launcher::prepare().
PreparedFleet prepare(Launcher& launcher, const Fleet& fleet, ChosenFleet chosen,
                      const wire::RunRequest& common, const Describe& describe, const wire::Hello& runner);

/// Returns one result for each robot, in the order of their numbers: `first` without its `others`, then the
/// others.
std::vector<result::RunResult> results_of(result::RunResult first);

/// Combines the results of all robots of a run. The combined verdict is `reached` if all robots have reached
/// their goals. Otherwise it is the verdict of the first robot that has not reached its goal. `why` begins
/// with that robot's name. The time is the longest time of a robot. Distance, energy and collisions are sums,
/// and outputs are concatenated.
///
/// The hashes of image and robot come from the first robot. All other values come from the robot that `why`
/// names, or from the first robot if all reached their goals. The result of a single robot stays unchanged.
result::RunResult whole_of(const result::RunResult& result, const wire::RunRequest& request);

/// Adds the place in the fleet file to a runner's error about a robot, "robot B: …". Returns any other error
/// unchanged.
InputError with_place(const Fleet& fleet, const InputError& error);

}  // namespace robosim::launch
