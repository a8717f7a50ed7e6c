// Limits JSON before a parser allocates memory: a parsed value needs up to thirty times the memory of its
// text.
#pragma once

#include <cstddef>
#include <string_view>

namespace robosim {

inline constexpr int kDeepestJson = 64;                    ///< levels of nested brackets
inline constexpr std::size_t kMostJsonValues = 2'000'000;  ///< keys also count as values

/// Returns whether a JSON text is within both limits.
bool is_within_json_limits(std::string_view text);

}  // namespace robosim
