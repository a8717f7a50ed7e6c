// Several robots on one map: what a user names of each, and the one request that comes of it.
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

/// One of them.
struct Member {
  std::string name;
  Launch launch;  ///< its script's text is in the request; its map does not count
  Place place;    ///< where a file has it
};

struct Fleet {
  std::vector<Member> members;  ///< in the order of their numbers
  std::string map;              ///< empty = not said
  std::string file;             ///< empty = there is none

  Member* find(const std::string& name);
};

/// Whether a word in the place of a sketch names a fleet's file.
bool is_fleet_file(const std::string& word);
/// Throws InputError.
Fleet read_fleet(const std::filesystem::path& file);
Fleet parse_fleet(std::string_view text, const std::filesystem::path& file);
/// Throws InputError if `name` cannot be a robot's.
void check_member_name(const std::string& name, const Place& place = {});

/// Whose runner runs firmware of all these targets.
std::string runner_of(const std::vector<std::string>& targets);

/// All of a fleet, chosen but not prepared.
struct ChosenFleet {
  std::vector<Chosen> members;
  std::string runner;  ///< target of the runner that has all of theirs
};
/// Throws InputError, of the robot that it is about.
ChosenFleet choose(Fleet& fleet);

struct PreparedFleet {
  std::vector<Prepared> members;
  wire::RunRequest request;  ///< of all
};
/// `common`: what is the same for all; of each member's request start, goal, clock and script count. Throws
/// as Launcher::prepare() does.
PreparedFleet prepare(Launcher& launcher, const Fleet& fleet, ChosenFleet chosen,
                      const wire::RunRequest& common, const Describe& describe, const wire::Hello& runner);

/// One for each robot, in the order of their numbers, the first one's without the others.
std::vector<wire::RunResult> results_of(wire::RunResult first);

/// What the robots of a run came to, as one result: reached if all have; else the verdict of the first that
/// has not, whose `why` begins with its name. Time is that of the last, distance, energy and collisions are
/// sums, what was sent and shown is that of all, one after the other; the rest is of the robot that `why` is
/// about, or the first. A run of one robot stays as it is.
wire::RunResult whole_of(const wire::RunResult& result, const wire::RunRequest& request);

/// What a runner says of one of its robots, "robot B: …", with the place where the fleet's file has it.
InputError with_place(const Fleet& fleet, const InputError& error);

}  // namespace robosim::launch
