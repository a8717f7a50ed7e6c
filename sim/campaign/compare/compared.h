// The result of a comparison of targets.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/campaign/analysis/compare.h"
#include "sim/campaign/analysis/pin_log.h"
#include "sim/launch/run_json.h"
#include "sim/result/lateness.h"

namespace robosim::campaign {

/// One side of the difference, in detail.
struct ComparedSide {
  std::string target;
  std::int64_t t_ns = 0;
  std::string text;           ///< the behaviour
  result::SourceLine source;  ///< the sketch's line with this behaviour; may be unknown
  std::vector<analysis::PinUse> reads;
  std::vector<analysis::PinUse> writes;
  std::vector<std::string> said;           ///< the last lines of output, ending with the differing line
  std::optional<result::Finding> finding;  ///< finding of a second run with sanitizers
};

/// The behaviour of one robot in one target run.
struct ComparedRun {
  std::string name;  ///< name of the robot, if there are several
  launch::RunInputs inputs;
  result::RunResult result;
};

/// A target whose behaviour changes with a slightly wrong clock, so that the difference is chance.
struct Edge {
  std::string target;
  int ppm = 0;                  ///< error of the clock …
  std::int64_t from_ns = 0;     ///< … from this time on
  analysis::Difference itself;  ///< difference of the run with that clock (sides[1]) from the unchanged run
  bool does_as_other = true;    ///< true: behaves like the other target; false: only changes in a similar way
  /// If both targets ran with many clocks: the number of clocks, and the number of runs that behaved like the
  /// other target.
  int clocks = 0, as_other = 0;
  /// Set if a tick of the host's clock decides between the two behaviours. late[i] are the delays
  /// (sim/result/lateness.h) with which the sketch on the host behaves like the target of sides[i]. If that
  /// target is the host, late[i] are the delays of the compared run.
  std::array<std::vector<result::Lateness>, 2> late;

  bool is_of_tick() const { return !late[0].empty() || !late[1].empty(); }
};

/// A target, and the behaviour of its robots.
struct ComparedTarget {
  std::string target;
  std::vector<ComparedRun> robots;
};

/// A known difference, with its robot and targets.
struct ComparedKnown {
  analysis::KnownDifference difference;
  std::string robot;  ///< empty for a single robot, also in the structures below
  std::array<std::string, 2> targets;
};

/// A comparison of all targets with one seed.
struct Compared {
  std::uint64_t seed = 1;
  std::string sketch;  ///< name of the sketch, or the fleet's file
  std::string moves;   ///< with several robots: the one that changes its target; empty = all
  std::vector<ComparedTarget> target_runs;
  std::vector<ComparedKnown> known;
  std::optional<analysis::Difference> difference;
  std::string robot;                  ///< the robot with the difference
  std::array<ComparedSide, 2> sides;  ///< the two sides of the difference
  std::vector<Edge> edges;  ///< one for each side, or one for a tick of the host; if any, the cause is chance

  /// The target that lacks the features in `lacks`.
  std::string lacking;
  /// The missing chip features that the sketch used before the difference. If there are any, the sketch is
  /// not the cause.
  std::vector<result::Lack> lacks;

  bool same() const { return !difference || !edges.empty() || !lacks.empty(); }
};

}  // namespace robosim::campaign
