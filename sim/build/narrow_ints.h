// Compiles `int values[6];` passed to a `uint16_t*`. avr-gcc only warns, since int has 16 bits there. On the
// host it is an error, and a conversion would be wrong.
#pragma once

#include <string>
#include <string_view>

namespace robosim::build {

/// Returns whether the messages show that error.
bool wants_narrow_ints(std::string_view messages);

/// Returns a sketch's source with an int of 16 bits, as on an AVR: `short` replaces it, except in `long int`,
/// comments and texts.
std::string with_narrow_ints(std::string_view source);

}  // namespace robosim::build
