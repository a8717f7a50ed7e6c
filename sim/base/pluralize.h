// Formats counts in sentences: "1 link", "2 links".
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace robosim {

/// Returns the number and the noun. The noun gets an s if the number is not 1.
std::string pluralize(std::size_t n, std::string_view noun);

}  // namespace robosim
