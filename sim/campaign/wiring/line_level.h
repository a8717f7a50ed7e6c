// Finds statements in a sketch's source about the level of a line sensor over black: `#define BLACK HIGH`,
// `bool onLine = analogRead(A0) > 500`, comments such as `LOW = white`, and branches such as
// `if (left == HIGH && right == LOW) turnLeft()`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/campaign/wiring/source_blocks.h"

namespace robosim::wiring {

struct StatedLevel {
  bool is_high = true;       ///< HIGH over black, or a large reading
  std::string why;           ///< "BLACK 1, config.h:7"
  bool is_by_turns = false;  ///< follows only from names such as turnLeft()
};

/// Returns the level over black, if the source states it without contradiction. Code outranks comments.
std::optional<StatedLevel> level_in_source(const std::vector<SourceText>& sources);

}  // namespace robosim::wiring
