// Decides whether a difference is chance. Runs each target with a slightly wrong clock, and delays the
// program on the host by up to 10 ms. docs/howto/comparing.md explains the method.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "sim/base/progress.h"
#include "sim/campaign/analysis/edge.h"
#include "sim/campaign/compare/compared.h"
#include "sim/campaign/compare/observer.h"
#include "sim/campaign/compare/target_runs.h"

namespace robosim::campaign {

/// A robot in two target runs.
struct Pair {
  std::size_t robot = 0;
  std::array<TargetRun*, 2> target_runs{};
  std::array<const analysis::History*, 2> histories{};
  std::array<std::vector<result::Lateness>, 2> late{};  ///< delays of the robot's sketch on the host
};

class JitterProbe {
 public:
  /// `make_host` builds the robot for the host, and returns null if that fails. find() calls `make_host` if
  /// no target run is on the host. All arguments must outlive this object.
  JitterProbe(const Observer& observer, Progress& progress, std::function<TargetRun*()> make_host)
      : observer_(observer), progress_(progress), make_host_(std::move(make_host)) {}

  /// Returns the edges (compared.h) for the difference in `compared`; empty if the targets cause the
  /// difference. The caller must have set compared.sides. A difference is never chance if it has a named
  /// cause, or if a run with sanitizers has found something.
  std::vector<Edge> find(const Compared& compared, const Pair& pair);

 private:
  using FromStart = std::map<int, analysis::History>;  ///< histories by the clock's error, ppm

  std::vector<Edge> find_of_clocks(const Compared& compared, const Pair& pair);
  std::vector<Edge> weigh(const Compared& compared, const Pair& pair);
  std::optional<Edge> find_of_clock(const Compared& compared, std::size_t side, const Pair& pair);
  std::vector<Edge> find_of_ticks(const Compared& compared, const Pair& pair);
  const analysis::History& run_from_start(TargetRun& target_run, const ObservedRobot& observed, int ppm);
  static ObservedRobot observed_robot_of(const Compared& compared, std::size_t side, const Pair& pair);

  const Observer& observer_;
  Progress& progress_;
  std::function<TargetRun*()> make_host_;
  std::map<const TargetRun*, FromStart> from_start_;  ///< for the target runs of one difference
};

}  // namespace robosim::campaign
