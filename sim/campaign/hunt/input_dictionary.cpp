#include "sim/campaign/hunt/input_dictionary.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace robosim::campaign {
namespace {

constexpr std::size_t kLongestWord = 24;
constexpr std::string_view kInclude = "#include", kOfEeprom = "EEPROM.read(";

/// Returns whether the string after `text` is printed: print("…"), println(F("…")).
bool is_printed(std::string_view text) {
  const auto drop = [&](std::string_view end) {
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    const bool is_there = text.ends_with(end);
    if (is_there) text.remove_suffix(end.size());
    return is_there;
  };
  return drop("F(") || drop("print(") || drop("println(");
}

}  // namespace

bool may_be_sent(const std::string& word) {
  return !word.empty() && word.size() <= kLongestWord && std::all_of(word.begin(), word.end(), [](char c) {
    return c >= ' ' && c <= '~' && c != '"' && c != '\\';
  });
}

void add_words(const std::string& source, std::vector<std::string>& words) {
  const auto add = [&](const std::string& literal) {
    // Splits the literal at escapes, because a literal may contain several words that each end with \0.
    std::string word;
    for (std::size_t i = 0; i < literal.size(); ++i) {
      if (literal[i] != '\\') {
        word += literal[i];
        continue;
      }
      words.push_back(std::exchange(word, ""));
      ++i;
    }
    words.push_back(word);
  };
  for (std::size_t i = 0; i < source.size(); ++i) {
    const char quote = source[i];
    if (source.compare(i, kInclude.size(), kInclude) == 0) {
      i = std::min(source.find('\n', i), source.size() - 1);
      continue;
    }
    if (quote != '"' && quote != '\'') continue;
    const std::size_t end = source.find_first_of(std::string{quote, '\n'}, i + 1);
    if (end == std::string::npos) return;
    if (source[end] == quote && !is_printed(std::string_view(source).substr(0, i)))
      add(source.substr(i + 1, end - i - 1));
    i = end;
  }
}

bool uses_eeprom(const std::string& source) {
  return source.find("EEPROM.") != std::string::npos || source.find("eeprom_") != std::string::npos;
}

bool reads_input(std::string source) {
  for (std::size_t at = 0; (at = source.find(kOfEeprom, at)) != std::string::npos;)
    source.erase(at, kOfEeprom.size());
  for (const char* const call : {".available(", ".read(", ".parse", "readString", "readBytes", "serialEvent"})
    if (source.find(call) != std::string::npos) return true;
  return false;
}

}  // namespace robosim::campaign
