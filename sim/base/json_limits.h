// Limits JSON before a parser allocates anything: a parsed value takes up to thirty times its text.
#pragma once

#include <cstddef>
#include <string_view>

namespace robosim {

inline constexpr int kDeepestJson = 64;                    ///< brackets in one another
inline constexpr std::size_t kMostJsonValues = 2'000'000;  ///< keys, too, count as values

/// Returns whether a text, if it is JSON, is within both limits.
bool is_within_json_limits(std::string_view text);

}  // namespace robosim
