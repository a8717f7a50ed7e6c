#include "sim/exec/gdb/connection.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "sim/base/error.h"

namespace robosim::exec::gdb {
namespace {

constexpr char kInterrupt = '\x03';
constexpr int kSlice_ms = 200;  // limits each poll(), which a signal that came just before would not end
constexpr std::size_t kLongestPacket = 1 << 16;

int checksum(std::string_view body) {
  unsigned sum = 0;
  for (const char c : body) sum += static_cast<unsigned char>(c);
  return static_cast<int>(sum & 0xFF);
}

}  // namespace

Connection::Connection(std::uint16_t port, const std::atomic<bool>& interrupted) : interrupted_(interrupted) {
  listener_ = Descriptor(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  const int yes = 1;
  ::setsockopt(listener_.get(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const bool bound =
      ::bind(listener_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  if (bound && ::listen(listener_.get(), 1) == 0) return;
  const int error = errno;
  if (error == EADDRINUSE)
    throw InputError(fmt::format(
        "port {} is in use by another program, so that no debugger can reach it; choose another, such as {}",
        port, port < 65535 ? port + 1 : port - 1));
  throw InputError(fmt::format("cannot wait for a debugger at port {}: {}", port, std::strerror(error)));
}

bool Connection::wait(int descriptor) {
  while (!interrupted_.load(std::memory_order_relaxed)) {
    pollfd ready{descriptor, POLLIN, 0};
    if (::poll(&ready, 1, kSlice_ms) > 0) return true;
  }
  return false;
}

bool Connection::accept() {
  while (wait(listener_.get())) {
    peer_ = Descriptor(::accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC));
    if (!open()) continue;
    const int yes = 1;
    ::setsockopt(peer_.get(), IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    break;
  }
  listener_.close();
  return open();
}

bool Connection::fill() {
  char bytes[4096];
  const ssize_t n = ::recv(peer_.get(), bytes, sizeof bytes, MSG_DONTWAIT);
  if (n < 0 && (errno == EAGAIN || errno == EINTR)) return false;
  if (n <= 0 || received_.size() > kLongestPacket) {
    close();
    return false;
  }
  received_.append(bytes, static_cast<std::size_t>(n));
  return true;
}

void Connection::write(std::string_view bytes) {
  while (open() && !bytes.empty()) {
    const ssize_t n = ::send(peer_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return close();
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
}

void Connection::send(std::string_view body) {
  std::string escaped;
  for (const char c : body) {
    if (std::strchr("$#}*", c) && c != '\0') {
      escaped += '}';
      escaped += static_cast<char>(c ^ 0x20);
    } else {
      escaped += c;
    }
  }
  write(fmt::format("${}#{:02x}", escaped, checksum(escaped)));
}

std::optional<std::string> Connection::take_packet() {
  for (;;) {
    // Drops the text before the packet: an acknowledgement ('+' or '-'), or a Ctrl-C that came too late.
    received_.erase(0, std::min(received_.find('$'), received_.size()));
    const std::size_t end = received_.find('#');
    if (end == std::string::npos || end + 2 >= received_.size()) return std::nullopt;
    std::string body = received_.substr(1, end - 1);
    const bool sound = received_.substr(end + 1, 2) == fmt::format("{:02x}", checksum(body));
    received_.erase(0, end + 3);
    if (!trusted_) write(sound ? "+" : "-");
    if (sound || trusted_) return body;
  }
}

std::optional<std::string> Connection::receive() {
  while (open()) {
    if (auto packet = take_packet()) return packet;
    if (!wait(peer_.get())) close();
    if (open()) fill();
  }
  return std::nullopt;
}

bool Connection::asks_to_halt() {
  if (!open()) return false;
  fill();
  const std::size_t at = received_.find(kInterrupt);
  if (at == std::string::npos) return !open();
  received_.erase(0, at + 1);
  return true;
}

}  // namespace robosim::exec::gdb
