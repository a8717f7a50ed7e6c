// Makes a sketch compile for the host if the sketch passes `int values[6];` to a `uint16_t*` parameter.
// avr-gcc, whose int has 16 bits, only warns about this call. For the host, the call is an error. A cast
// would compile, but give wrong values.
#pragma once

#include <string>
#include <string_view>

namespace robosim::build {

/// Returns whether the messages report such a call.
bool wants_narrow_ints(std::string_view messages);

/// Returns a sketch's source with 16-bit ints, as on an AVR. `short` replaces `int`, except in `long int`,
/// comments and literals.
std::string with_narrow_ints(std::string_view source);

}  // namespace robosim::build
