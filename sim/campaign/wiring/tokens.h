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

/// Returns the words of a name, in lower case: "leftMotor_EN1" is left, motor, en, 1.
std::vector<std::string> words_of(const std::string& name);

}  // namespace robosim::wiring
