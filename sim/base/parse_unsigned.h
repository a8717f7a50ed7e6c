// Parses whole numbers in the forms that people write.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace robosim {

/// Returns a number such as "12" or "0x0C"; nothing for other text.
std::optional<std::uint64_t> parse_unsigned(std::string_view text);

}  // namespace robosim
