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
  /// Throws InputError if it is none, or none of that kind.
  explicit LinePattern(const std::string& text);

  /// Whether a part of the line matches. Firmware sends bytes, whatever they mean.
  bool is_in(const std::string& line) const;

 private:
  std::shared_ptr<const re2::RE2> expression_;
};

}  // namespace robosim::run
