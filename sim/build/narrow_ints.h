// `int values[6];` handed to a `uint16_t*`: avr-gcc warns, for an int has 16 bits there; on the host it is an
// error, and a conversion would be wrong.
#pragma once

#include <string>
#include <string_view>

namespace robosim::build {

/// Whether the messages say so.
bool wants_narrow_ints(std::string_view messages);

/// A sketch's source in which int has 16 bits, as on an AVR: `short` in its place, but in `long int`,
/// comments and texts.
std::string with_narrow_ints(std::string_view source);

}  // namespace robosim::build
