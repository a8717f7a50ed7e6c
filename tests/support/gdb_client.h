// Implements gdb's side of its remote protocol. Packets are sent in advance and replies are read afterwards,
// so one thread can run both sides.
#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <string>

namespace robosim::test {

/// A socket that listens at a free port of this machine, so that no other program can use the port.
class Port {
 public:
  Port() : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    EXPECT_EQ(::bind(socket_, reinterpret_cast<sockaddr*>(&address), size), 0);
    EXPECT_EQ(::listen(socket_, 1), 0);
    EXPECT_EQ(::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size), 0);
    number_ = ntohs(address.sin_port);
  }
  ~Port() { ::close(socket_); }
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;
  std::uint16_t number() const { return number_; }

 private:
  int socket_;
  std::uint16_t number_ = 0;
};

/// Returns a port without a listener.
inline std::uint16_t free_port() { return Port().number(); }

class GdbClient {
 public:
  explicit GdbClient(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    const timeval patience{5, 0};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  }
  ~GdbClient() { leave(); }
  GdbClient(const GdbClient&) = delete;
  GdbClient& operator=(const GdbClient&) = delete;

  void leave() {
    if (socket_ >= 0) ::close(socket_);
    socket_ = -1;
  }
  void send_bytes(const std::string& bytes) {
    EXPECT_EQ(::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL), static_cast<ssize_t>(bytes.size()));
  }
  void say(const std::string& body) {
    unsigned sum = 0;
    for (const char c : body) sum += static_cast<unsigned char>(c);
    char end[4];
    std::snprintf(end, sizeof end, "#%02x", sum & 0xFF);
    send_bytes("$" + body + end);
  }
  void press_ctrl_c() { send_bytes("\x03"); }

  /// Returns the next reply without "+" and "-", or "(gone)" if there is none.
  std::string reply() {
    for (;;) {
      const std::size_t start = received_.find('$');
      const std::size_t end = received_.find('#', start);
      if (start != std::string::npos && end != std::string::npos && end + 2 < received_.size()) {
        const std::string body = received_.substr(start + 1, end - start - 1);
        received_.erase(0, end + 3);
        return body;
      }
      char bytes[4096];
      const ssize_t n = ::recv(socket_, bytes, sizeof bytes, 0);
      if (n <= 0) return "(gone)";
      received_.append(bytes, static_cast<std::size_t>(n));
    }
  }

 private:
  int socket_;
  std::string received_;
};

}  // namespace robosim::test
