// Finds the ends of names and of string and character literals, for the readers of C++ text in this folder.
#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string_view>

namespace robosim::build {

inline bool is_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// Finds the ends of string and character literals, from the beginning of a source to its end.
class QuoteEnds {
 public:
  explicit QuoteEnds(std::string_view source) : source_(source) {}

  /// Returns the end of the literal whose quote is at `at`. If the literal does not end in its line, returns
  /// the position after the quote.
  std::size_t of(std::size_t at) {
    // Without this limit, a line of unclosed quotes would be searched once for each quote.
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
  int open_ = 0;  ///< number of unclosed quotes in the line that ends at line_end_
};

}  // namespace robosim::build
