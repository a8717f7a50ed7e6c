// Parses whole numbers as people write them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace robosim {

/// Returns the number in "12" or "0x0C"; nothing for anything else.
std::optional<std::uint64_t> parse_unsigned(std::string_view text);

}  // namespace robosim
