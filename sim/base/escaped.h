// Texts as scripts write them between double quotes.
#pragma once

#include <string>
#include <string_view>

namespace robosim {

/// With \n, \r, \t, \" and \\ for what they stand for.
std::string escaped(std::string_view text);

}  // namespace robosim
