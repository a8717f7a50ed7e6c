// Numbers of things in sentences: "1 link", "2 links".
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace robosim {

/// The number and the noun, with an s unless there is one of it.
std::string counted(std::size_t n, std::string_view noun);

}  // namespace robosim
