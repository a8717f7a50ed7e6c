// Naming a strange character in a message.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace robosim::grid {

/// The character at text[at], as messages name it: "`é` (U+00E9)", "a tab", "a NUL byte", "the byte 0xE9,
/// which is not UTF-8".
std::string describe_character(std::string_view text, std::size_t at);

}  // namespace robosim::grid
