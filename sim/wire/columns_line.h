// Lines of columns, quickly: nlohmann's parser and writer look at each character several times, which would
// cost more than all else that a recording does.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/wire/columns.h"
#include "sim/wire/stream.h"

namespace robosim::wire {

/// As JSON: what to_json() gives, in its order, as text.
std::string columns_text(const Columns& columns);

/// The same of a batch.
std::string batch_text(const Batch& batch);
/// A line of JSON that ends with the long text of a batch: in its place `left` has kCutText, and the result
/// is the text. Nothing where the line is none, or the text needs more than copying.
std::optional<std::string_view> cut_batch(std::string_view line, std::string& left);
inline constexpr const char* kCutText = "#";  // which is no base64

/// The long texts in the arrays of a line of JSON, each replaced by "#" and its number, which is no base64.
class LongTexts {
 public:
  /// Gives the line that is left: all of it if there is a text in it that needs more than copying. The line
  /// must outlive this.
  std::string cut(std::string_view line);
  void put_back(Columns& columns) const;

 private:
  std::vector<std::string_view> texts_;  ///< in the line
};

}  // namespace robosim::wire
