// Converts a Trial to a request for a runner.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robosim/testing/fleet.h"
#include "robosim/testing/simulation.h"
#include "sim/build/sketch.h"
#include "sim/launch/client/runner.h"
#include "sim/launch/fleet.h"

namespace robosim::testing {

/// A runner that is borrowed from a pool. The destructor returns the runner to the pool, for later tests.
class Borrowed {
 public:
  explicit Borrowed(const std::string& target);
  ~Borrowed();
  Borrowed(const Borrowed&) = delete;
  Borrowed& operator=(const Borrowed&) = delete;
  client::Runner& operator*() { return *runner_; }
  client::Runner* operator->() { return runner_.get(); }
  /// Marks the runner as broken, because it violated the protocol or died. A broken runner does not return to
  /// the pool.
  void condemn() { sound_ = false; }

 private:
  std::string target_;
  std::unique_ptr<client::Runner> runner_;
  bool sound_ = true;
};

/// A compiled sketch.
struct Built {
  build::Request request;
  build::Image image;
};

/// A Trial after its names (sketch, map, robot) were resolved.
struct ResolvedTrial {
  wire::RunRequest request;
  wire::RobotInfo robot;
  std::string sketch, map, robot_name, target;  ///< in the form of the robosim command's arguments
  std::vector<std::string> libraries;
  std::string sketch_title;      ///< for messages: "PidFollower"
  std::optional<Built> counted;  ///< the build whose lines are counted; implies that request.counters is set
  bool map_is_text = false, robot_is_text = false;
  std::filesystem::path scratch;  ///< folder for a map or robot that was given as text; empty = none
};

/// Returns the Trial's target. If the sketch is a finished .elf, returns the target of that file instead.
std::string target_of(const Trial& trial);
/// Returns the part of the map's graph that is reachable from the request's start.
Graph graph_of_floor(const wire::RunRequest& request);
/// Resolves a Trial. Throws the same exceptions as Simulation's constructor.
ResolvedTrial resolve_trial(const Trial& trial, client::Runner& runner);

/// A FleetTrial after its names (sketches, map, robots) were resolved.
struct ResolvedFleetTrial {
  std::vector<Trial> trials;  ///< for each robot: a Trial for a run without the others
  launch::Fleet fleet;
  launch::ChosenFleet chosen;
  bool map_is_text = false;
  std::filesystem::path scratch;  ///< folder for maps and robots that were given as texts; empty = none
};
/// Resolves a FleetTrial. Throws the same exceptions as Fleet's constructor.
ResolvedFleetTrial resolve_fleet_trial(const FleetTrial& trial);
/// Returns each robot's resolved trial. The first one contains the request of the whole run.
std::vector<ResolvedTrial> resolve_trials(const FleetTrial& trial, ResolvedFleetTrial& all,
                                          client::Runner& runner);

}  // namespace robosim::testing
