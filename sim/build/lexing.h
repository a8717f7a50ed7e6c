// Finds names, literals and comments, for the C++ parsers in this folder.
#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string>
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

/// Separates the code of a C++ source from comments and literals.
class CodeScanner {
 public:
  CodeScanner(const std::string& text, std::size_t at) : text_(text), at_(at) {}

  std::size_t at() const { return at_; }
  bool done() const { return at_ >= text_.size(); }
  char peek() const { return text_[at_]; }
  /// Skips one character of code, or a whole comment or literal.
  void step() {
    const char c = text_[at_];
    if (c == '"' || c == '\'') {
      skip_literal(c);
    } else if (text_.compare(at_, 2, "//") == 0) {
      at_ = std::min(text_.find('\n', at_), text_.size());
    } else if (text_.compare(at_, 2, "/*") == 0) {
      const std::size_t end = text_.find("*/", at_ + 2);
      at_ = end == std::string::npos ? text_.size() : end + 2;
    } else {
      ++at_;
    }
  }

 private:
  void skip_literal(char end) {
    for (++at_; at_ < text_.size() && text_[at_] != end && text_[at_] != '\n'; ++at_)
      if (text_[at_] == '\\') ++at_;
    if (at_ < text_.size()) ++at_;
  }

  const std::string& text_;
  std::size_t at_;
};

}  // namespace robosim::build
