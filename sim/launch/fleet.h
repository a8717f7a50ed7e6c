// Several robots on one map: the user's names for each, and the one request made from them.
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
  Launch launch;  ///< its script's text is in the request; its map is ignored
  Place place;    ///< in the fleet's file
};

struct Fleet {
  std::vector<Member> members;  ///< in the order of their numbers
  std::string map;              ///< empty = not given
  std::string file;             ///< empty = none

  Member* find(const std::string& name);
};

/// Returns whether a sketch argument names a fleet's file.
bool is_fleet_file(const std::string& word);
/// Reads a fleet's file. Throws InputError.
Fleet read_fleet(const std::filesystem::path& file);
Fleet parse_fleet(std::string_view text, const std::filesystem::path& file);
/// Throws InputError if `name` cannot be a robot's.
void check_member_name(const std::string& name, const Place& place = {});

/// Returns the target whose runner runs firmware of all these targets.
std::string runner_of(const std::vector<std::string>& targets);

/// A whole fleet, chosen but not prepared.
struct ChosenFleet {
  std::vector<Chosen> members;
  std::string runner;  ///< target of the runner for all of them
};
/// Chooses each robot's files. Throws InputError, with the robot's name.
ChosenFleet choose(Fleet& fleet);

struct PreparedFleet {
  std::vector<Prepared> members;
  wire::RunRequest request;  ///< for all of them
};
/// Prepares a fleet. `common`: the settings for all; each member's request adds start, goal, clock and
/// script. Throws as Launcher::prepare() does.
PreparedFleet prepare(Launcher& launcher, const Fleet& fleet, ChosenFleet chosen,
                      const wire::RunRequest& common, const Describe& describe, const wire::Hello& runner);

/// Returns one result for each robot, in the order of their numbers; the first without the others.
std::vector<wire::RunResult> results_of(wire::RunResult first);

/// Returns the results of all robots of a run as one. It is reached if all have reached their goals. Else it
/// has the verdict of the first that has not, whose `why` begins with its name. Time is the last one's,
/// distance, energy and collisions are sums, and outputs are concatenated. The rest is of the robot in `why`,
/// or of the first. A run of one robot stays unchanged.
wire::RunResult whole_of(const wire::RunResult& result, const wire::RunRequest& request);

/// Returns a runner's error about one of its robots, "robot B: …", with the place in the fleet's file.
InputError with_place(const Fleet& fleet, const InputError& error);

}  // namespace robosim::launch
