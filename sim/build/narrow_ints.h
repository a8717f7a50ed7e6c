// Makes `int values[6];` compile for the host where it is passed to a `uint16_t*`. avr-gcc only warns, since
// its int has 16 bits. On the host this is an error, and a conversion would be wrong.
#pragma once

#include <string>
#include <string_view>

namespace robosim::build {

/// Returns whether the messages contain that error.
bool wants_narrow_ints(std::string_view messages);

/// Returns a sketch's source with 16-bit ints, as on an AVR. `short` replaces `int`, except in `long int`,
/// comments and literals.
std::string with_narrow_ints(std::string_view source);

}  // namespace robosim::build
