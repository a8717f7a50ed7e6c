#include "sim/build/source_words.h"

#include <cctype>
#include <cstdlib>
#include <set>

#include "sim/build/lexing.h"

namespace robosim::build {

std::vector<Word> words_in(const std::string& text) {
  std::vector<Word> words;
  QuoteEnds quote_ends(text);
  std::string_view file;
  int line = 1;
  bool begins = true;  // at the beginning of a line
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '\n') {
      ++line, ++i;
      begins = true;
    } else if (c == '#' && begins) {  // # 12 "name", #line 12 "name"
      const std::size_t end = text.find('\n', i);
      const std::string_view directive = std::string_view(text).substr(i, end - i);
      if (const std::size_t digit = directive.find_first_of("0123456789"); digit != directive.npos)
        line = std::atoi(text.c_str() + i + digit) - 1;
      if (const std::size_t quote = directive.find('"'); quote != directive.npos)
        file = directive.substr(quote + 1, directive.find('"', quote + 1) - quote - 1);
      i = end == std::string::npos ? text.size() : end;
    } else if (std::isspace(static_cast<unsigned char>(c))) {
      ++i;
    } else {
      std::size_t end = i + 1;
      if (c == '"' || c == '\'')
        end = quote_ends.of(i);
      else if (is_of_name(c))
        while (end < text.size() && is_of_name(text[end])) ++end;
      words.push_back({std::string_view(text).substr(i, end - i), file, line});
      i = end;
      begins = false;
    }
  }
  return words;
}

std::optional<int> number_of(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  if (text.size() > kLongest) return std::nullopt;
  const std::string word(text);
  const bool binary = word.rfind("0b", 0) == 0 || word.rfind("0B", 0) == 0;
  const char* begin = word.c_str() + (binary ? 2 : 0);
  char* end = nullptr;
  const long value = std::strtol(begin, &end, binary ? 2 : 0);
  while (end && (*end == 'u' || *end == 'U' || *end == 'l' || *end == 'L')) ++end;
  if (end == begin || *end || value < 0 || value > 255) return std::nullopt;
  return static_cast<int>(value);
}

bool is_name(std::string_view word) {
  return is_of_name(word[0]) && !std::isdigit(static_cast<unsigned char>(word[0]));
}

std::map<std::string_view, int> constants_in(const std::vector<Word>& words) {
  std::map<std::string_view, int> found;
  std::set<std::string_view> several;
  for (std::size_t i = 0; i + 2 < words.size(); ++i) {
    const std::string_view name = words[i].text;
    if (!is_name(name)) continue;
    const std::string_view next = words[i + 1].text;
    const bool compares = next == "=" && words[i + 2].text == "=";
    const bool counts =
        (next == "+" || next == "-") && (words[i + 2].text == next || words[i + 2].text == "=");
    const bool counted = i > 1 && (words[i - 1].text == "+" || words[i - 1].text == "-") &&
                         words[i - 2].text == words[i - 1].text;
    const bool shared = i > 0 && words[i - 1].text == "&";
    // A parameter, a member or a local variable of the same name may have any value.
    const bool declared = i > 0 && is_name(words[i - 1].text) &&
                          (next == "," || next == ")" || next == ";" || next == ":" || next == "[");
    if (counts || counted || shared || declared) several.insert(name);
    if (next != "=" || compares) continue;
    const bool alone = i + 3 < words.size() && (words[i + 3].text == ";" || words[i + 3].text == ",");
    const auto value = alone ? number_of(words[i + 2].text) : std::nullopt;
    if (!value || !found.emplace(name, *value).second) several.insert(name);
  }
  for (const std::string_view name : several) found.erase(name);
  return found;
}

}  // namespace robosim::build
