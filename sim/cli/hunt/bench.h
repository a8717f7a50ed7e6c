// Makes a hunt's runs: a sketch compiled for each of its builds, worlds written as files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/build/cache.h"
#include "sim/cli/arguments.h"
#include "sim/cli/hunt/world.h"
#include "sim/client/pool.h"
#include "sim/launch/launch.h"
#include "sim/tui/progress.h"

namespace robosim::cli {

class HuntBench {
 public:
  /// Compiles. Throws InputError, ToolMissing and wire::RunnerError.
  HuntBench(const HuntArguments& arguments, tui::Progress& progress);

  HuntSpace& space() { return space_; }
  const HuntSpace& space() const { return space_; }
  const wire::RobotInfo& robot() const { return robot_; }
  const launch::Prepared& of(const HuntWorld& world) const { return prepared_[world.build]; }
  const std::string& version() const { return version_; }
  /// In place of the robot's own; empty = that.
  const std::string& board() const { return board_; }
  /// Why a build that was to be run is left out; a sentence each.
  const std::vector<std::string>& left_out() const { return left_out_; }
  /// Of everything that the runs come from.
  std::string fingerprint() const;
  /// Whether the user has said where to drive; else the first map is a guess, and others may do.
  bool maps_are_given() const { return maps_are_given_; }
  void keep_maps(const std::vector<std::size_t>& maps);
  /// The names of the others, on which the sketch is taken not to be meant to drive.
  const std::vector<std::string>& left_maps() const { return left_maps_; }

  /// What happens meanwhile: the user's script, then the world's.
  std::string script_of(const HuntWorld& world) const { return script_ + script_text(world, space_); }
  /// `folder` gets the files of the world that are not there yet: world.map, robot.toml.
  wire::RunRequest request_of(const HuntWorld& world, const std::string& folder) const;

  /// The results, in the order of the worlds; none of a world that cannot be. `ran`: the sketch's lines that
  /// ran, of worlds on a chip without checks. False if it was interrupted.
  bool run(const std::vector<HuntWorld>& worlds, std::vector<std::optional<wire::RunResult>>& results,
           std::vector<std::vector<std::string>>* ran = nullptr);
  client::Pool& pool() { return pool_; }
  /// Worlds that could not be, and why the first could not.
  std::size_t refused() const { return refused_; }
  const std::string& refusal() const { return refusal_; }

 private:
  /// One run: a world, or those of a family.
  struct Task {
    std::size_t first = 0, count = 1;
  };
  std::vector<Task> tasks_of(const std::vector<HuntWorld>& worlds) const;
  wire::RunRequest request_of_all(const std::vector<HuntWorld>& worlds, const Task& task,
                                  const std::string& folder) const;
  void prepare(const HuntArguments& arguments, tui::Progress& progress);
  void look_at_maps(const HuntArguments& arguments);
  void look_at_robot(const HuntArguments& arguments, client::Runner& describer);
  void look_at_sketch();

  build::WorkFolder work_;
  client::Pool pool_;
  HuntSpace space_;
  wire::RobotInfo robot_;
  std::string board_;                       ///< in place of the robot's own
  std::string script_;                      ///< of the user
  std::vector<launch::Prepared> prepared_;  ///< of each build
  std::vector<std::string> map_files_;      ///< of each map
  std::vector<std::string> left_maps_;
  std::vector<std::string> left_out_;
  std::string version_;
  std::string options_;  ///< all that was asked for, one thing a line
  std::size_t refused_ = 0;
  std::string refusal_;
  bool maps_are_given_ = false;
};

}  // namespace robosim::cli
