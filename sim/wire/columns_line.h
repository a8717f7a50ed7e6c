// Reads and writes lines of columns quickly. nlohmann's parser and writer examine each character several
// times, which would cost more than all other work of a recording.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/wire/columns.h"

namespace robosim::wire {

/// Returns columns as JSON, with bytes as base64.
std::string columns_text(const Columns& columns);

/// Cuts the long texts out of the arrays in a line of JSON, so that parsing the line is faster. Replaces each
/// text by "#" and a number. Base64 never contains "#".
class LongTexts {
 public:
  /// Returns the line without its long texts, or the whole line if a text contains escapes. The line must
  /// outlive this object.
  std::string cut(std::string_view line);
  /// Restores bytes from their base64. Throws BadValue if the base64 is invalid.
  void put_back(Columns& columns) const;

 private:
  std::vector<std::string_view> texts_;  ///< the texts that were cut out, indexed by number
};

}  // namespace robosim::wire
