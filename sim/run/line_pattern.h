// Matches a regular expression in a time that is linear in the length of the text.
#pragma once

#include <memory>
#include <string>

namespace re2 {
class RE2;
}

namespace robosim::run {

class LinePattern {
 public:
  /// Compiles a regular expression. Throws InputError if it is invalid, or needs more than linear time.
  explicit LinePattern(const std::string& text);

  /// Returns whether any part of the line matches. The line may have any encoding, because firmware may send
  /// any bytes.
  bool is_in(const std::string& line) const;

 private:
  std::shared_ptr<const re2::RE2> expression_;
};

}  // namespace robosim::run
