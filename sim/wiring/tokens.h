// The words of a C++ source, as far as names of pins need them: no comments, no directives but #define.
#pragma once

#include <string>
#include <vector>

namespace robosim::wiring {

struct Token {
  enum class Kind {
    word,
    number,
    text,         ///< a string or character
    punctuation,  ///< one character; `end` behind a #define
    define,       ///< the name behind `#define`; what it stands for follows
  };
  Kind kind;
  std::string text;
  int line = 0;

  bool is(const char* what) const { return text == what && kind != Kind::text; }
};

/// What stands behind the last token of a #define.
inline constexpr const char* kEndOfDefine = "end";

std::vector<Token> tokens_of(const std::string& source);

/// The words that a name is made of, in small letters: "leftMotor_EN1" is left, motor, en, 1.
std::vector<std::string> words_of(const std::string& name);

}  // namespace robosim::wiring
