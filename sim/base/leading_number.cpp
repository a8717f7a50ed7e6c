#include "sim/base/leading_number.h"

#include <charconv>
#include <cmath>

namespace robosim {

std::optional<LeadingNumber> leading_number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  return LeadingNumber{value, static_cast<std::size_t>(end - text.data())};
}

}  // namespace robosim
