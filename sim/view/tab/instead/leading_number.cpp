// Replaces std::from_chars for a double, which libc++ 13 lacks. strtod() of musl rounds in the same way.
#include "sim/base/leading_number.h"

#include <cmath>
#include <cstdlib>
#include <string>

namespace robosim {
namespace {

std::size_t digits_from(std::string_view text, std::size_t at) {
  const std::size_t end = text.find_first_not_of("0123456789", at);
  return (end == std::string_view::npos ? text.size() : end) - at;
}

/// Returns the length of a number such as `-1.5e3`; 0 if there is no number.
std::size_t length_of(std::string_view text) {
  std::size_t at = text.starts_with('-') ? 1 : 0;
  const std::size_t whole = digits_from(text, at);
  at += whole;
  const std::size_t fraction = at < text.size() && text[at] == '.' ? digits_from(text, at + 1) : 0;
  if (whole + fraction == 0) return 0;
  if (at < text.size() && text[at] == '.') at += 1 + fraction;
  if (at >= text.size() || (text[at] != 'e' && text[at] != 'E')) return at;
  const bool is_signed = at + 1 < text.size() && (text[at + 1] == '-' || text[at + 1] == '+');
  const std::size_t begin = at + (is_signed ? 2 : 1), exponent = digits_from(text, begin);
  return exponent > 0 ? begin + exponent : at;
}

}  // namespace

std::optional<LeadingNumber> leading_number(std::string_view text) {
  const std::string number(text.substr(0, length_of(text)));
  if (number.empty()) return std::nullopt;
  const double value = std::strtod(number.c_str(), nullptr);
  const bool vanished =
      value == 0.0 && number.substr(0, number.find_first_of("eE")).find_first_of("123456789") != number.npos;
  if (!std::isfinite(value) || vanished) return std::nullopt;
  return LeadingNumber{value, number.size()};
}

}  // namespace robosim
