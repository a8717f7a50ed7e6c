// Parses the number at the start of a text.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace robosim {

struct LeadingNumber {
  double value = 0.0;
  std::size_t length = 0;  ///< number of parsed characters
};

/// Parses a decimal number at the start of `text`, with or without fraction and exponent, as in "-1.5e3 mm".
/// Returns nothing if there is no number, or if a double cannot represent it. The locale has no influence.
std::optional<LeadingNumber> leading_number(std::string_view text);

}  // namespace robosim
