// Splits a C++ source into the tokens that the search for pin names needs. Skips comments, and all directives
// except #define.
#pragma once

#include <string>
#include <vector>

namespace robosim::wiring {

struct Token {
  enum class Kind {
    word,
    number,
    text,         ///< a string or character
    punctuation,  ///< one character; `end` after a #define
    define,       ///< the name after `#define`; its replacement follows
  };
  Kind kind;
  std::string text;
  int line = 0;

  bool is(const char* what) const { return text == what && kind != Kind::text; }
};

/// The text of the token that marks the end of a #define.
inline constexpr const char* kEndOfDefine = "end";

std::vector<Token> tokens_of(const std::string& source);

using WordList = std::vector<std::string>;  ///< words of a name or of a comment, in lower case

/// One line of a comment.
struct Comment {
  std::string text;
  int line = 0;
  bool is_alone = true;  ///< no code precedes the comment on its line
};

std::vector<Comment> comments_of(const std::string& source);

/// Returns the names in #include "name".
std::vector<std::string> includes_of(const std::string& source);

/// Returns the words of a text in lower case, without accents: "Sağ motor" is sag, motor.
std::vector<std::string> words_of_text(const std::string& text);

/// Returns the words of a name, in lower case: "leftMotor_EN1" is left, motor, en, 1. The word pin also
/// counts without a border: PINENA is pin, ena.
std::vector<std::string> words_of(const std::string& name);

}  // namespace robosim::wiring
