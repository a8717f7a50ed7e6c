#include "sim/build/narrow_ints.h"

#include <cctype>

#include "sim/build/lexing.h"

namespace robosim::build {
namespace {

/// Returns the end of the comment or literal that begins at `at`; `at` if neither begins there.
std::size_t end_of_passage(std::string_view source, std::size_t at, QuoteEnds& quote_ends) {
  const auto behind = [&](std::string_view end, std::size_t from) {
    const std::size_t found = source.find(end, from);
    return found == source.npos ? source.size() : found + end.size();
  };
  if (source.substr(at, 2) == "//") return behind("\n", at);
  if (source.substr(at, 2) == "/*") return behind("*/", at + 2);
  if (source[at] != '"' && source[at] != '\'') return at;
  return quote_ends.of(at);
}

}  // namespace

bool wants_narrow_ints(std::string_view messages) {
  constexpr std::string_view kBegin = "error: cannot convert '";
  for (std::size_t at = messages.find(kBegin); at != messages.npos; at = messages.find(kBegin, at + 1)) {
    const std::string_view line = messages.substr(at + kBegin.size(), messages.find('\n', at) - at);
    const std::size_t to = line.find("' to '");
    if (to == line.npos) continue;
    std::string_view from = line.substr(0, to);
    for (const std::string_view word : {"const ", "volatile ", "unsigned "})
      if (from.substr(0, word.size()) == word) from.remove_prefix(word.size());
    const bool points = from == "int*" || from.substr(0, 5) == "int [";
    const std::string_view wanted = line.substr(to + 6, line.find("'", to + 6) - to - 6);
    if (points && (wanted.find("int16_t*") != wanted.npos || wanted.find("short") != wanted.npos))
      return true;
  }
  return false;
}

std::string with_narrow_ints(std::string_view source) {
  std::string result;
  std::string_view last;
  QuoteEnds quote_ends(source);
  for (std::size_t at = 0; at < source.size();) {
    if (const std::size_t end = end_of_passage(source, at, quote_ends); end != at) {
      result += source.substr(at, end - at);
      at = end;
      continue;
    }
    std::size_t end = at + 1;
    if (is_of_name(source[at])) {
      while (end < source.size() && is_of_name(source[end])) ++end;
      const std::string_view word = source.substr(at, end - at);
      const bool wide = last == "long" || last == "short";
      result += word == "int" && !wide ? "short" : word;
      last = word;
    } else {
      if (!std::isspace(static_cast<unsigned char>(source[at]))) last = {};
      result += source[at];
    }
    at = end;
  }
  return result;
}

}  // namespace robosim::build
