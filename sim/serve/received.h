// Returns how much of a request the HTTP library has read so far.
#pragma once

#include <cstddef>

namespace robosim::serve {

/// Returns the number of bytes of a TCP connection that its reader has taken; 0 if the system does not report
/// it.
std::size_t bytes_taken(int socket);

}  // namespace robosim::serve
