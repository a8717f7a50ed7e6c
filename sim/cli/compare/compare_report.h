// What `robosim compare` prints.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/analysis/compare.h"
#include "sim/analysis/pin_log.h"
#include "sim/cli/run/run_json.h"
#include "sim/cli/run/second_look.h"
#include "sim/wire/lateness.h"

namespace robosim::cli {

/// One side of the difference, in detail.
struct ComparedSide {
  std::string target;
  std::int64_t t_ns = 0;
  std::string text;         ///< what it did
  wire::SourceLine source;  ///< the sketch's line that did it; may be unknown
  std::vector<analysis::PinUse> reads;
  std::vector<analysis::PinUse> writes;
  std::vector<std::string> said;   ///< its last lines before, and the one itself
  std::optional<Finding> finding;  ///< of a run with checks
};

/// What one robot did in one lane.
struct ComparedRun {
  std::string name;  ///< the robot's, where there are several
  RunInputs inputs;
  wire::RunResult result;
};

/// That a target goes another way, if its clock is a little off: chance decides there.
struct Edge {
  std::string target;
  int ppm = 0;                  ///< by which its clock was off …
  std::int64_t from_ns = 0;     ///< … from this time on
  analysis::Difference itself;  ///< sides[0]: as it is; sides[1]: with that clock
  bool does_as_other = true;    ///< there; else it differs from itself in a like way
  /// Where both targets have been tried with many clocks: with so many it does as the other did.
  int clocks = 0, as_other = 0;
  /// Of the host, where a tick of its clock decides: how late its sketch is where it does as either target;
  /// as it is for one of them, at least.
  std::array<std::vector<wire::Lateness>, 2> late;

  bool is_of_tick() const { return !late[0].empty() || !late[1].empty(); }
};

/// A target, and what its robots did.
struct ComparedLane {
  std::string target;
  std::vector<ComparedRun> robots;
};

/// A known difference, of which robot and between which targets.
struct ComparedKnown {
  analysis::KnownDifference difference;
  std::string robot;  ///< empty where there is one; the same below
  std::array<std::string, 2> targets;
};

/// A comparison of all targets with one seed.
struct Compared {
  std::uint64_t seed = 1;
  std::string sketch;  ///< or the fleet's file
  std::string moves;   ///< the one of several robots that is put on the targets; empty = all
  std::vector<ComparedLane> lanes;
  std::vector<ComparedKnown> known;
  std::optional<analysis::Difference> difference;
  std::string robot;                  ///< whose the difference is
  std::array<ComparedSide, 2> sides;  ///< of the difference
  std::vector<Edge>
      edges;  ///< of both sides, or of the host's ticks: the difference says nothing of the targets

  /// What this target lacks of the chip, and the sketch had used before the difference: that says nothing of
  /// the sketch.
  std::string lacking;
  std::vector<wire::Lack> lacks;

  bool same() const { return !difference || !edges.empty() || !lacks.empty(); }
};

std::string compare_text(const Compared& compared);
/// Schema robosim.compare/1, in one line.
std::string compare_json(const Compared& compared);

}  // namespace robosim::cli
