// Splits C++ sources into tokens, for checks and guesses that need no full parser. Skips comments, and all
// directives except #define.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace robosim::build {

/// A token. It refers to the text without a copy, because each character of a text may be a token.
struct Token {
  enum class Kind : char {
    word,
    number,
    text,         ///< a string or character, with its quotes
    punctuation,  ///< one character, also an unclosed quote; kEndOfDefine after a #define
    define,       ///< the name after `#define`; its replacement follows
  };
  std::string_view text;
  std::string_view file;  ///< file of the last line marker, with escapes
  int line = 0;
  Kind kind = Kind::punctuation;

  bool is(std::string_view what) const { return text == what; }
  std::string str() const { return std::string(text); }
};

/// The text of the token that marks the end of a #define.
inline constexpr std::string_view kEndOfDefine = "\n";

/// Returns the tokens of `source`, which must outlive them. A preprocessor's line markers determine the
/// tokens' files and lines.
std::vector<Token> tokens_of(std::string_view source);

/// One line of a comment.
struct Comment {
  std::string_view text;
  int line = 0;
  bool is_alone = true;  ///< no code precedes the comment on its line
};

/// Returns the comments of `source`, which must outlive them.
std::vector<Comment> comments_of(std::string_view source);

/// The number of the next line, and its file as written in the marker, with escapes.
struct LineMarker {
  int line = 0;
  std::string_view file;
};

/// Reads `# 12 "Blink.ino" 2` or `#line 12 "Blink.ino"`; empty for other lines.
std::optional<LineMarker> line_marker(std::string_view line);

/// Returns the value of a number from 0 to 255; nothing for other text.
std::optional<int> number_of(std::string_view text);

/// Returns whether the text is a name or a keyword.
bool is_name(std::string_view text);

/// Returns variables that are set exactly once, to a number.
std::map<std::string_view, int> constants_in(const std::vector<Token>& tokens);

}  // namespace robosim::build
