// Shared by the readers of C++ text here: finds where a name, a text or a character ends.
#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string_view>

namespace robosim::build {

inline bool is_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// Finds the ends of texts and characters, from the beginning of a source to its end.
class QuoteEnds {
 public:
  explicit QuoteEnds(std::string_view source) : source_(source) {}

  /// Returns where the literal ends whose quote stands at `at`; after that quote if its line does not end it.
  std::size_t of(std::size_t at) {
    // A line of nothing but quotes that do not end would be gone through for each of them.
    constexpr int kMostOpen = 100;
    if (at < line_end_ && open_ >= kMostOpen) return at + 1;
    std::size_t i = at + 1;
    for (; i < source_.size() && source_[i] != '\n'; ++i) {
      if (source_[i] == '\\')
        ++i;
      else if (source_[i] == source_[at])
        return i + 1;
    }
    if (at >= line_end_) open_ = 0;
    line_end_ = std::max(line_end_, i);
    ++open_;
    return at + 1;
  }

 private:
  std::string_view source_;
  std::size_t line_end_ = 0;
  int open_ = 0;  ///< in the line that ends there
};

}  // namespace robosim::build
