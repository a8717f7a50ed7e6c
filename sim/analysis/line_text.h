// A line that firmware has printed, as words and numbers.
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
  std::string form;  ///< the text with "#" for each number, and "＃" for each # of its own
  std::vector<Number> numbers;
};

LineText take_apart(const std::string& line);

/// The text in quotes, cut where it is long.
std::string quoted(const std::string& text);

/// How two numbers compare that different targets have printed.
enum class Likeness {
  same,   ///< the same text, or within the tolerance
  known,  ///< the same value, printed differently: the last digits of a float, the width of a negative HEX
  different,
};
Likeness likeness(const Number& a, const Number& b, double tolerance);

/// "float formatting" or "width of long", for numbers whose likeness is `known`.
std::string known_cause(const Number& a, const Number& b);
/// A clause if they differ by what an integer of 16 or 32 bits loses on overflow; otherwise empty.
std::string width_cause(const Number& a, const Number& b);

}  // namespace robosim::analysis
