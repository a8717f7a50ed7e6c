#include "sim/build/arithmetic_warnings.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "sim/build/declarations.h"
#include "sim/build/tokens.h"

namespace robosim::build {
namespace {

/// A number in the source, or a constant.
struct Number {
  std::string text;
  double value = 0;
  bool is_integer = true;
  bool is_variable = false;
  std::size_t end = 0;  ///< index of the next word
};

class ArithmeticCheck {
 public:
  // The number of an int's bits has no influence on this check.
  explicit ArithmeticCheck(const std::vector<Token>& words)
      : words_(words), names_(words, 16), constants_(constants_in(words)) {}

  std::string warnings() {
    for (std::size_t i = 1; i < words_.size(); ++i) {
      check_quotient(i);
      check_variable(i);
      check_delay(i);
    }
    return std::move(text_);
  }

 private:
  std::string_view word(std::size_t at) const { return at < words_.size() ? words_[at].text : ""; }

  bool is_adjacent(std::size_t at) const {
    return at + 1 < words_.size() && word(at).data() + word(at).size() == word(at + 1).data();
  }

  bool is_number(std::size_t at) const {
    return at < words_.size() && words_[at].kind == Token::Kind::number &&
           word(at).find_first_not_of("0123456789fFuUlL") == std::string_view::npos;
  }

  /// Reads a decimal number without exponent, such as 25, 0.35f or .5.
  std::optional<Number> number_at(std::size_t at) const {
    Number number{.end = at};
    if (is_number(at)) number.text = words_[number.end++].str();
    const bool has_digits = number.end > at;
    if (word(number.end) == "." && (!has_digits || is_adjacent(at))) {
      number.is_integer = false;
      const bool has_more = is_adjacent(number.end) && is_number(number.end + 1);
      if (!has_digits && !has_more) return std::nullopt;
      number.text += '.';
      if (++number.end; has_more) number.text += words_[number.end++].str();
    } else if (!has_digits) {
      return std::nullopt;
    }
    constexpr std::size_t kLongest = 20;
    if (number.text.size() > kLongest) return std::nullopt;
    if (number.text.find_first_of("fF") != number.text.npos) number.is_integer = false;
    if (number.is_integer && number.text.size() > 1 && number.text[0] == '0') return std::nullopt;  // octal
    number.value = std::strtod(number.text.c_str(), nullptr);
    return number;
  }

  bool is_integer_variable(std::size_t at) const {
    return names_.all_of(word(at),
                         [](const ArithmeticType& type) { return type.bits > 0 && !type.is_float; });
  }

  /// Returns whether the name's declaration begins with `const` or `constexpr`.
  bool is_constant(std::size_t at) const {
    const std::size_t declaration = names_.resolve(at, false);
    if (declaration == Declarations::kNone) return false;
    constexpr std::size_t kMostWords = 40;
    const std::size_t name = names_.all()[declaration].at;
    for (std::size_t i = name; i-- > 0 && name - i < kMostWords;) {
      if (word(i) == "const" || word(i) == "constexpr") return true;
      if (word(i) == ";" || word(i) == "}" || word(i) == "{" || word(i) == ")") return false;
    }
    return false;
  }

  /// Reads an integer, or an integer constant.
  std::optional<Number> integer_at(std::size_t at) const {
    if (const std::optional<Number> number = number_at(at)) return number->is_integer ? number : std::nullopt;
    const auto constant = constants_.find(word(at));
    if (constant == constants_.end() || !is_integer_variable(at) || !is_constant(at)) return std::nullopt;
    return Number{
        .text = words_[at].str(), .value = double(constant->second), .is_variable = true, .end = at + 1};
  }

  bool is_pair(std::size_t at, std::string_view pair) const {
    return word(at) == pair.substr(0, 1) && word(at + 1) == pair.substr(1);
  }

  /// Returns whether an operand of a division can begin at `at`: in `a * 1 / 2`, the operand is `a * 1`.
  bool begins_operand(std::size_t at) const {
    const std::string_view before = word(at - 1);
    if (at > 1 && (is_pair(at - 2, "->") || is_pair(at - 2, "::"))) return false;
    return before == "return" ||
           (before.size() == 1 && std::string_view("(=,{[+-?:<>&|;").find(before) != std::string_view::npos);
  }

  void check_quotient(std::size_t at) {
    if (word(at) != "/" || word(at + 1) == "=") return;
    const std::optional<Number> dividend = integer_at(at - 1);
    if (!dividend || dividend->end != at || !begins_operand(at - 1)) return;
    const std::optional<Number> divisor = integer_at(at + 1);
    if (!divisor || dividend->value == 0 || dividend->value >= divisor->value) return;
    // The number may be only the beginning of a float, of 1'000, of a call, an element or a member.
    const std::size_t end = divisor->end;
    if (const std::string_view after = word(end);
        !after.empty() && std::string_view(".'([").find(after[0]) != std::string_view::npos)
      return;
    if (is_pair(end, "->") || is_pair(end, "::")) return;
    const std::string as_float = dividend->is_variable ? "(float)" + dividend->text : dividend->text + ".0";
    warn(at, fmt::format("{0} / {1} is 0, because a quotient of integers has no fraction: for {2:.3g}, write "
                         "{3} / {1}",
                         dividend->text, divisor->text, dividend->value / divisor->value, as_float));
  }

  /// Returns the number at `at` if it is an expression by itself. Its fraction must be at
  /// least a tenth of its value.
  std::optional<Number> lost_fraction(std::size_t at) const {
    const bool is_negative = word(at) == "-";
    std::optional<Number> number = number_at(at + is_negative);
    if (!number || number->is_integer) return std::nullopt;
    const std::string_view after = word(number->end);
    if (after != ";" && after != "," && after != ")") return std::nullopt;
    constexpr double kLeastLoss = 0.1;
    if (number->value - std::floor(number->value) < kLeastLoss * number->value || number->value == 0)
      return std::nullopt;
    if (is_negative) number->text.insert(0, "-"), number->value = -number->value;
    return number;
  }

  void check_variable(std::size_t at) {
    if (word(at) != "=" || !is_name(word(at - 1)) || !is_integer_variable(at - 1)) return;
    if (const std::optional<Number> number = lost_fraction(at + 1))
      warn(at, fmt::format("'{0}' has an integer type, so it becomes {1}, not {2}: declare '{0}' as float",
                           word(at - 1), std::trunc(number->value) + 0.0, number->text));
  }

  void check_delay(std::size_t at) {
    const bool is_us = word(at) == "delayMicroseconds";
    if ((word(at) != "delay" && !is_us) || word(at + 1) != "(") return;
    if (const std::optional<Number> number = lost_fraction(at + 2); number && word(number->end) == ")")
      warn(at, fmt::format("{0}({1}) waits {2} {3}: its number has no fraction", word(at), number->text,
                           std::trunc(number->value) + 0.0, is_us ? "µs" : "ms"));
  }

  void warn(std::size_t at, const std::string& wrong) {
    if (!warned_.insert(wrong).second) return;
    text_ += fmt::format("{}{}:{}: warning: {}", text_.empty() ? "" : "\n", words_[at].file, words_[at].line,
                         wrong);
  }

  const std::vector<Token>& words_;
  const Declarations names_;
  const std::map<std::string_view, int> constants_;
  std::set<std::string> warned_;
  std::string text_;
};

}  // namespace

std::string arithmetic_warnings(const std::string& own_lines) {
  const std::vector<Token> words = tokens_of(own_lines);
  return ArithmeticCheck(words).warnings();
}

}  // namespace robosim::build
