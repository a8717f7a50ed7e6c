// Whole numbers as people write them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace robosim {

/// The number that "12" or "0x0C" says.
std::optional<std::uint64_t> parse_whole(std::string_view text);

}  // namespace robosim
