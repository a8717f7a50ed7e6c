// Escapes text for strings in double quotes in Robosim's scripts and messages.
#pragma once

#include <string>
#include <string_view>

namespace robosim {

/// Returns `text` with line feeds, carriage returns, tabs, double quotes and backslashes escaped.
std::string escaped(std::string_view text);

}  // namespace robosim
