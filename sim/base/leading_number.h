// The number that a text begins with.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace robosim {

struct LeadingNumber {
  double value = 0.0;
  std::size_t length = 0;  ///< of what was read
};

/// Decimal, with or without fraction and exponent: "-1.5e3 mm" begins with one. Nothing where there is none,
/// or none that a double holds. The same on every machine, whatever its locale.
std::optional<LeadingNumber> leading_number(std::string_view text);

}  // namespace robosim
