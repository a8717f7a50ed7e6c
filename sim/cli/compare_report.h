// What `robosim compare` prints.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/cli/run_json.h"
#include "sim/cli/second_look.h"
#include "sim/client/compare.h"
#include "sim/client/evidence.h"

namespace robosim::cli {

/// One side of the difference, in detail.
struct ComparedSide {
  std::string target;
  std::int64_t t_ns = 0;
  std::string text;       ///< what it did
  client::Source source;  ///< the sketch's line that did it; may be unknown
  std::vector<client::PinUse> reads;
  std::vector<client::PinUse> writes;
  std::vector<std::string> said;   ///< its last lines before, and the one itself
  std::optional<Finding> finding;  ///< of a run with checks
};

struct ComparedRun {
  RunInputs inputs;
  client::RunResult result;
};

/// A comparison of all targets with one seed.
struct Compared {
  std::uint64_t seed = 1;
  std::vector<ComparedRun> runs;
  std::vector<client::KnownDifference> known;
  std::vector<std::array<std::string, 2>> known_targets;  ///< of each known difference
  std::optional<client::Difference> difference;
  std::array<ComparedSide, 2> sides;  ///< of the difference
};

std::string compare_text(const Compared& compared);
/// Schema robosim.compare/1, in one line.
std::string compare_json(const Compared& compared);

}  // namespace robosim::cli
