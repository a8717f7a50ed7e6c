// A regular expression that is matched in linear time.
#pragma once

#include <memory>
#include <string>

namespace re2 {
class RE2;
}

namespace robosim::run {

class LinePattern {
 public:
  /// Throws InputError for an invalid regular expression, or one that needs more than linear time.
  explicit LinePattern(const std::string& text);

  /// Returns whether a part of the line matches. Firmware sends bytes in any encoding.
  bool is_in(const std::string& line) const;

 private:
  std::shared_ptr<const re2::RE2> expression_;
};

}  // namespace robosim::run
