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

struct ComparedRun {
  RunInputs inputs;
  wire::RunResult result;
};

/// A comparison of all targets with one seed.
struct Compared {
  std::uint64_t seed = 1;
  std::vector<ComparedRun> runs;
  std::vector<analysis::KnownDifference> known;
  std::vector<std::array<std::string, 2>> known_targets;  ///< of each known difference
  std::optional<analysis::Difference> difference;
  std::array<ComparedSide, 2> sides;  ///< of the difference
};

std::string compare_text(const Compared& compared);
/// Schema robosim.compare/1, in one line.
std::string compare_json(const Compared& compared);

}  // namespace robosim::cli
