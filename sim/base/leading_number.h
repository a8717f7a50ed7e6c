// Parses the number at the beginning of a text.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace robosim {

struct LeadingNumber {
  double value = 0.0;
  std::size_t length = 0;  ///< of what was read
};

/// Parses a decimal number, with or without fraction and exponent: "-1.5e3 mm" begins with one. Returns
/// nothing if there is none, or a double cannot hold it. The locale has no influence.
std::optional<LeadingNumber> leading_number(std::string_view text);

}  // namespace robosim
