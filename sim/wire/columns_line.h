// Lines of columns, quickly: nlohmann's parser and writer look at each character several times, which would
// cost more than all else that a recording does.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/wire/columns.h"

namespace robosim::wire {

/// As JSON, bytes as base64.
std::string columns_text(const Columns& columns);

/// The long texts in the arrays of a line of JSON, each replaced by "#" and its number, which is no base64.
class LongTexts {
 public:
  /// Gives the line that is left: all of it if there is a text in it that needs more than copying. The line
  /// must outlive this.
  std::string cut(std::string_view line);
  /// Puts bytes in the place of their base64. Throws BadValue where it is none.
  void put_back(Columns& columns) const;

 private:
  std::vector<std::string_view> texts_;  ///< in the line
};

}  // namespace robosim::wire
