// Finds out how much of a request the HTTP library has read so far.
#pragma once

#include <cstddef>

namespace robosim::serve {

/// Returns the number of bytes that the reader of a TCP connection has read; 0 if the system does not report
/// it.
std::size_t bytes_taken(int socket);

}  // namespace robosim::serve
