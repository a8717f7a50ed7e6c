// Finds the pins of calls in counted loops: for (int i = 0; i < 8; i++) analogRead(FIRST + i).
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/build/tokens.h"

namespace robosim::wiring {

/// A series of pins, as words of the source.
struct PinRange {
  std::string base;         ///< pin to which the loop's variable is added; empty = 0
  std::string first, last;  ///< first value of the variable, and the limit
  bool is_inclusive = false;
};

class CountedLoops {
 public:
  /// Reads the loop whose `for` is the token at index `at`.
  void read(const std::vector<build::Token>& tokens, std::size_t at);
  /// Returns the range of an argument that contains the variable of a loop: `i`, `FIRST + i`.
  std::optional<PinRange> range_of(const std::string& argument) const;

 private:
  std::map<std::string, PinRange> by_variable_;
};

/// Returns the pins of a range, as words: A0, A1 …, or 2, 3 … Returns none if they are not constants.
std::vector<std::string> pins_in(const PinRange& range,
                                 const std::function<std::string(const std::string&)>& value_of);

}  // namespace robosim::wiring
