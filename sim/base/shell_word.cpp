#include "sim/base/shell_word.h"

namespace robosim {

std::string shell_word(const std::string& text) {
  constexpr const char* kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./,:=+-@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::optional<std::vector<std::string>> shell_words(const std::string& command) {
  std::vector<std::string> words;
  bool quoted = false, open = false;  // `quoted`: inside quotes; `open`: inside a word
  for (std::size_t i = 0; i < command.size(); ++i) {
    const char c = command[i];
    if (!quoted && c == ' ') {
      open = false;
      continue;
    }
    if (!open) words.emplace_back();
    open = true;
    if (c == '\'')
      quoted = !quoted;
    else
      words.back() += !quoted && c == '\\' && i + 1 < command.size() ? command[++i] : c;
  }
  if (quoted) return std::nullopt;
  return words;
}

}  // namespace robosim
