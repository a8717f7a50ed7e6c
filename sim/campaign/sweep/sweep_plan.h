// The plan of a sweep: every sketch on every map with every robot on every target, each with all seeds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim/campaign/sweep/sweep_options.h"
#include "sim/launch/client/pool.h"
#include "sim/launch/run_json.h"

namespace robosim::campaign {

/// A fingerprint of all inputs of a run except its seed. It has several parts, so that the changed part can
/// be reported. Each part has 8 hexadecimal digits, the beginning of a SHA-256.
struct Fingerprint {
  /// The image, the map, the robot, and everything else: Robosim's version, and options that all runs share.
  std::array<std::string, 4> parts;
  /// Returns "0123abcd-…"
  std::string text() const;
};

/// One sketch on one map with one robot on one target.
struct Combination {
  launch::RunInputs inputs;  ///< as reported by `--json`
  std::string title;         ///< name of the sketch for display: not "."
  client::Task task;         ///< without its seed
  std::string image_sha256;
  std::string map_sha256;
  std::string robot_sha256;
  Fingerprint fingerprint;
  std::string replay;  ///< the command that repeats one of its runs, without --seed
  /// Returns "PidFollower on oval with uno5, target host"
  std::string text() const;
};

/// Runs are numbered from 0: first all seeds of the first combination, then all seeds of the second …
struct SweepPlan {
  std::vector<Combination> combinations;
  std::uint64_t first_seed = 1;
  std::size_t seeds = 0;
  /// A sentence about each sketch that does not compile. Such a sketch has no combinations.
  std::vector<std::string> left_out;

  std::size_t runs() const { return combinations.size() * seeds; }
  const Combination& combination_of(std::size_t run) const { return combinations[run / seeds]; }
  std::uint64_t seed_of(std::size_t run) const { return first_seed + run % seeds; }
  client::Task task_of(std::size_t run) const;
};

class SweepSupplies;

/// Finds the files and compiles the sketches. Work that several sweeps share is done and reported only once.
class SweepPlanner {
 public:
  explicit SweepPlanner(launch::Listener listener);
  ~SweepPlanner();

  /// Makes the plan. Skips sketches that do not compile, unless none compiles. Throws InputError, ToolMissing
  /// and wire::RunnerError.
  SweepPlan plan(const SweepOptions& options);

 private:
  std::unique_ptr<SweepSupplies> supplies_;
};

/// Returns the command that repeats one run.
std::string replay_command(const Combination& combination, std::uint64_t seed);

}  // namespace robosim::campaign
