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
#include "sim/client/runner.h"
#include "sim/launch/fleet.h"

namespace robosim::testing {

/// A runner from a pool, which keeps runners for later tests.
class Borrowed {
 public:
  explicit Borrowed(const std::string& target);
  ~Borrowed();
  Borrowed(const Borrowed&) = delete;
  Borrowed& operator=(const Borrowed&) = delete;
  client::Runner& operator*() { return *runner_; }
  client::Runner* operator->() { return runner_.get(); }
  /// It has broken the protocol or died: it is not returned to the pool.
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

/// The resolved names of a Trial.
struct ResolvedTrial {
  wire::RunRequest request;
  wire::RobotInfo robot;
  std::string sketch, map, robot_name, target;  ///< as the robosim command takes them
  std::vector<std::string> libraries;
  std::string sketch_title;      ///< for messages: "PidFollower"
  std::optional<Built> counted;  ///< build whose lines are counted, if any; request.counters is set then
  bool map_is_text = false, robot_is_text = false;
  std::filesystem::path scratch;  ///< folder of files made of texts; empty = none
};

/// Returns the target of a finished .elf, else the Trial's.
std::string target_of(const Trial& trial);
/// Returns the graph of a request's map, as it is reachable from its start.
Graph graph_of_floor(const wire::RunRequest& request);
/// Resolves a Trial. Throws as Simulation's constructor does.
ResolvedTrial resolve_trial(const Trial& trial, client::Runner& runner);

/// The resolved names of a FleetTrial.
struct ResolvedFleetTrial {
  std::vector<Trial> trials;  ///< of each robot, as if it were alone
  launch::Fleet fleet;
  launch::ChosenFleet chosen;
  bool map_is_text = false;
  std::filesystem::path scratch;  ///< folder of files made of texts; empty = none
};
/// Resolves a FleetTrial. Throws as Fleet's constructor does.
ResolvedFleetTrial resolve_fleet_trial(const FleetTrial& trial);
/// Returns each robot's resolved trial; the first one's request is that of the whole run.
std::vector<ResolvedTrial> resolve_trials(const FleetTrial& trial, ResolvedFleetTrial& all,
                                          client::Runner& runner);

}  // namespace robosim::testing
