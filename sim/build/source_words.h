// Splits preprocessed sources into words, for checks that need no full parser.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace robosim::build {

/// A word of a text, which can have as many words as characters.
struct Word {
  std::string_view text;  ///< a name, a number, a string's quote, or one character
  std::string_view file;
  int line = 0;
};

/// Returns the words of `text`, which must outlive them. Line markers of a preprocessor set files and lines.
std::vector<Word> words_in(const std::string& text);

/// Returns the value of a number from 0 to 255.
std::optional<int> number_of(std::string_view text);

/// Returns whether the word is a name or a keyword.
bool is_name(std::string_view word);

/// Returns variables that are set exactly once, to a number.
std::map<std::string_view, int> constants_in(const std::vector<Word>& words);

}  // namespace robosim::build
