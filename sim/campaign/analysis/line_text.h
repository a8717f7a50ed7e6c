// Splits a line of the firmware's output into words and numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace robosim::analysis {

struct Number {
  std::string text;
  double value = 0.0;
  enum class Form { whole, fraction, hexadecimal, binary } form = Form::whole;
};

struct LineText {
  std::string form;  ///< the text with "#" for each number, and "＃" for each literal #
  std::vector<Number> numbers;
};

LineText take_apart(const std::string& line);

/// Returns the text in quotes, truncated if it is long.
std::string quoted(const std::string& text);

/// The similarity of two numbers from different targets.
enum class Likeness {
  same,   ///< equal text, or within the tolerance
  known,  ///< equal value, printed differently: the last digits of a float, or a negative HEX's width
  different,
};
Likeness likeness(const Number& a, const Number& b, double tolerance);

/// Returns "float formatting" or "width of long", for numbers whose likeness is `known`.
std::string known_cause(const Number& a, const Number& b);
/// Returns an explanation if an overflow of a 16- or 32-bit integer explains the difference; otherwise "".
std::string width_cause(const Number& a, const Number& b);

}  // namespace robosim::analysis
