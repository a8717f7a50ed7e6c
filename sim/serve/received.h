// How much of a request the HTTP library has read so far.
#pragma once

#include <cstddef>

namespace robosim::serve {

/// Returns the bytes of a TCP connection that its reader has taken; 0 where the system does not say.
std::size_t bytes_taken(int socket);

}  // namespace robosim::serve
