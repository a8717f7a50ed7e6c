// Implements bytes_taken(). This file is separate, because linux/tcp.h and the headers of the HTTP library
// define the same structs.
#include "sim/view/serve/received.h"

#include <linux/tcp.h>
#include <netinet/in.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <algorithm>
#include <cstddef>

namespace robosim::serve {

std::size_t bytes_taken(int socket) {
  tcp_info info{};
  socklen_t size = sizeof info;
  int waiting = 0;
  if (::ioctl(socket, FIONREAD, &waiting) != 0) return 0;
  if (::getsockopt(socket, IPPROTO_TCP, TCP_INFO, &info, &size) != 0) return 0;
  if (size < offsetof(tcp_info, tcpi_bytes_received) + sizeof info.tcpi_bytes_received) return 0;
  const auto received = static_cast<std::size_t>(info.tcpi_bytes_received);
  return received - std::min(received, static_cast<std::size_t>(waiting));
}

}  // namespace robosim::serve
