#include "sim/campaign/analysis/line_text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace robosim::analysis {
namespace {

constexpr double kFloat = 1e-5;  // relative error of a 32-bit float after some arithmetic
constexpr double kInt = 65536.0, kLong = 4294967296.0;
constexpr std::size_t kLongestShown = 60;
constexpr std::size_t kHexDigits = 4, kBinaryDigits = 16;  // minimum number of digits in HEX, and in BIN

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_hex(char c) { return is_digit(c) || (c >= 'A' && c <= 'F'); }
bool is_word(char c) { return is_digit(c) || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; }

template <typename Test>
std::size_t end_of(const std::string& line, std::size_t at, Test test) {
  while (at < line.size() && test(line[at])) ++at;
  return at;
}

/// Returns the end of the upper-case hexadecimal word at `at`; `at` itself if there is no such word.
std::size_t end_of_hex(const std::string& line, std::size_t at) {
  const std::size_t end = end_of(line, at, is_hex);
  if (end - at < kHexDigits || (end < line.size() && is_word(line[end]))) return at;
  const std::string word = line.substr(at, end - at);
  const bool letters = !std::all_of(word.begin(), word.end(), is_digit);
  const bool digits = std::any_of(word.begin(), word.end(), is_digit) || word.starts_with("FF");
  return letters && digits ? end : at;
}

std::size_t end_of_decimal(const std::string& line, std::size_t at, bool& fraction) {
  std::size_t end = end_of(line, line[at] == '-' || line[at] == '+' ? at + 1 : at, is_digit);
  fraction = end + 1 < line.size() && line[end] == '.' && is_digit(line[end + 1]);
  return fraction ? end_of(line, end + 1, is_digit) : end;
}

bool extends(const Number& longer, const Number& shorter, char filler) {
  const std::size_t more = longer.text.size() - shorter.text.size();
  return longer.text.compare(more, std::string::npos, shorter.text) == 0 &&
         longer.text.find_first_not_of(filler) >= more;
}

/// Returns whether both numbers are the same negative value in HEX or BIN, from types of different widths.
bool wider(const Number& a, const Number& b) {
  if (a.form != b.form || a.text.size() == b.text.size()) return false;
  const char filler = a.form == Number::Form::hexadecimal ? 'F' : '1';
  if (a.form != Number::Form::hexadecimal && a.form != Number::Form::binary) return false;
  return a.text.size() > b.text.size() ? extends(a, b, filler) : extends(b, a, filler);
}

}  // namespace

LineText take_apart(const std::string& line) {
  LineText parts;
  for (std::size_t at = 0; at < line.size();) {
    const bool fresh = at == 0 || !is_word(line[at - 1]);
    const bool sign = (line[at] == '-' || line[at] == '+') && at + 1 < line.size() && is_digit(line[at + 1]);
    std::size_t end = at;
    Number number;
    if (fresh && (end = end_of_hex(line, at)) > at) {
      number.form = Number::Form::hexadecimal;
    } else if (is_digit(line[at]) || (fresh && sign)) {
      bool fraction = false;
      end = end_of_decimal(line, at, fraction);
      if (fraction) number.form = Number::Form::fraction;
    }
    if (end == at) {
      // Marks a literal #: otherwise "# 1" and "1 2" would have the same form.
      if (line[at] == '#')
        parts.form += "＃";
      else
        parts.form += line[at];
      ++at;
      continue;
    }
    number.text = line.substr(at, end - at);
    if (number.form == Number::Form::whole && number.text.size() >= kBinaryDigits &&
        number.text.find_first_not_of("01") == number.text.npos)
      number.form = Number::Form::binary;
    const int base = number.form == Number::Form::hexadecimal ? 16
                     : number.form == Number::Form::binary    ? 2
                                                              : 10;
    number.value = base == 10 ? std::strtod(number.text.c_str(), nullptr)
                              : static_cast<double>(std::strtoull(number.text.c_str(), nullptr, base));
    parts.form += '#';
    parts.numbers.push_back(std::move(number));
    at = end;
  }
  return parts;
}

std::string quoted(const std::string& text) {
  return "\"" + (text.size() > kLongestShown ? text.substr(0, kLongestShown) + "…" : text) + "\"";
}

/// Returns one unit of the last decimal place that both numbers have, as the tolerance for rounding.
double last_place(const Number& a, const Number& b) {
  const auto decimals = [](const Number& n) { return n.text.size() - n.text.find('.') - 1; };
  return 1.001 * std::pow(10.0, -static_cast<double>(std::min(decimals(a), decimals(b))));
}

Likeness likeness(const Number& a, const Number& b, double tolerance) {
  if (a.text == b.text) return Likeness::same;
  if (wider(a, b)) return Likeness::known;
  const double largest = std::max(std::fabs(a.value), std::fabs(b.value));
  const double apart = std::fabs(a.value - b.value);
  const bool fractions = a.form == Number::Form::fraction && b.form == Number::Form::fraction;
  if (fractions && apart <= kFloat * largest) return Likeness::known;
  if (fractions && apart <= last_place(a, b)) return Likeness::same;
  return apart <= tolerance * largest ? Likeness::same : Likeness::different;
}

std::string known_cause(const Number& a, const Number& b) {
  return wider(a, b) ? "width of long" : "float formatting";
}

std::string width_cause(const Number& a, const Number& b) {
  const double apart = std::fabs(a.value - b.value);
  if (apart == 0.0 || apart != std::floor(apart)) return "";
  const Number& larger = a.value > b.value ? a : b;
  const Number& smaller = a.value > b.value ? b : a;
  const bool lost_32 = std::fmod(apart, kLong) == 0.0;
  if (!lost_32 && std::fmod(apart, kInt) != 0.0) return "";
  const double unit = lost_32 ? kLong : kInt;
  const auto times = static_cast<long long>(apart / unit);
  return "integer width: " + smaller.text + " = " + larger.text + " - " +
         (times == 1 ? "" : std::to_string(times) + " * ") + (lost_32 ? "2^32" : "2^16") +
         (lost_32 ? ", which does not fit 32 bits" : ", which does not fit 16 bits");
}

}  // namespace robosim::analysis
