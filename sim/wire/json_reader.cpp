#include "sim/wire/json_reader.h"

namespace robosim::wire {
namespace detail {

std::string whole_number(const Rules& rules, std::int64_t least, std::uint64_t most) {
  constexpr auto kNoLeast = std::numeric_limits<std::int32_t>::min();
  constexpr auto kNoMost = static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max());
  std::string text =
      rules.multiple_of == 1 ? "a whole number" : "a multiple of " + std::to_string(rules.multiple_of);
  if (least > kNoLeast) text += " from " + std::to_string(least);
  if (most < kNoMost) text += " to " + std::to_string(most);
  return text;
}

std::string text(const Rules& rules) {
  if (rules.not_empty) return "a string that is not empty";
  if (rules.one_of.size() == 0) return "a string";
  std::vector<std::string> quoted;
  for (const char* word : rules.one_of) quoted.push_back("\"" + std::string(word) + "\"");
  return one_of(quoted);
}

std::string all_of(const std::vector<const char*>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "\"" : i + 1 < names.size() ? ", \"" : " and \"") + std::string(names[i]) + "\"";
  return text;
}

}  // namespace detail

std::string excerpt(std::string_view text) {
  constexpr std::size_t kMost = 120;
  std::string result;
  for (const char c : text.substr(0, kMost)) result += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
  return "“" + result + (text.size() > kMost ? "…”" : "”");
}

void JsonReader::finish() const {
  if (unknown_ == Unknown::refused) {
    for (auto at = object_.begin(); at != object_.end(); ++at) {
      const bool known =
          std::any_of(known_.begin(), known_.end(), [&](const char* key) { return at.key() == key; });
      if (!known) throw BadValue(at.key().substr(0, 40), "unknown key; expected " + one_of(known_));
    }
  }
  if (!choices_.empty() && chosen_ != 1)
    throw BadValue("", "expected exactly one of the keys " + one_of(choices_));
}

}  // namespace robosim::wire
