// Converts texts to names for the parameters of GoogleTest tests.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace robosim::test {

/// Returns the words of a text in characters that gtest allows, at most 30 letters: "3:7: no unit" becomes
/// 3_7NoUnit.
inline std::string readable(std::string_view text) {
  std::string name;
  bool begins = true;
  for (const char c : text) {
    const bool lower = c >= 'a' && c <= 'z', upper = c >= 'A' && c <= 'Z', digit = c >= '0' && c <= '9';
    if (digit && begins && !name.empty() && name.back() <= '9') name += '_';
    if (lower || upper || digit) name += lower && begins ? static_cast<char>(c - 'a' + 'A') : c;
    begins = !lower && !upper && !digit;
  }
  return name.substr(0, 30);
}

inline std::string readable(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += word + ' ';
  return readable(text);
}

/// Names parameters by their numbers and by a text member: numbered(&Refused::says).
template <class Parameter, class Text>
auto numbered(Text Parameter::*text) {
  return [text](const testing::TestParamInfo<Parameter>& test) {
    return std::to_string(test.index) + "_" + readable(test.param.*text);
  };
}

}  // namespace robosim::test
