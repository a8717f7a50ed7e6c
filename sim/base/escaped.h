// Escapes text for the double quotes of scripts.
#pragma once

#include <string>
#include <string_view>

namespace robosim {

/// Returns the text with \n, \r, \t, \" and \\ escaped.
std::string escaped(std::string_view text);

}  // namespace robosim
