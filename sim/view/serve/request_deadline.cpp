#include "sim/view/serve/request_deadline.h"

#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/view/serve/received.h"

namespace robosim::serve {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kReadAtOnce = 64 * 1024, kMostAway = 4 * 1024 * 1024;
constexpr int kPause_ms = 100;  // silence after which no more input is expected
constexpr std::size_t kMostHead = 64 * 1024;
constexpr auto kLook = std::chrono::milliseconds(20);  // period of checks
constexpr std::string_view kHeadTooLong =
    "HTTP/1.1 431 Request Header Fields Too Large\r\nContent-Length: 0\r\nConnection: close\r\n\r\n";

ino_t inode_of(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 ? status.st_ino : 0;
}

/// Returns whether a descriptor is a connection to the server's port.
bool is_connection(int descriptor, int port) {
  sockaddr_storage own{}, peer{};
  socklen_t own_size = sizeof own, peer_size = sizeof peer;
  if (::getsockname(descriptor, reinterpret_cast<sockaddr*>(&own), &own_size) != 0) return false;
  if (::getpeername(descriptor, reinterpret_cast<sockaddr*>(&peer), &peer_size) != 0) return false;
  if (own.ss_family == AF_INET) return ntohs(reinterpret_cast<const sockaddr_in&>(own).sin_port) == port;
  return own.ss_family == AF_INET6 && ntohs(reinterpret_cast<const sockaddr_in6&>(own).sin6_port) == port;
}

}  // namespace

thread_local RequestDeadline::Connection* RequestDeadline::own_ = nullptr;

RequestDeadline::RequestDeadline(int port, std::chrono::milliseconds most, std::string answer)
    : port_(port), most_(most), answer_(std::move(answer)), watcher_([this] { watch(); }) {}

RequestDeadline::~RequestDeadline() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_one();
  watcher_.join();
}

RequestDeadline::Connection* RequestDeadline::accepted() {
  const std::lock_guard lock(mutex_);
  std::error_code error;
  for (fs::directory_iterator entry("/proc/self/fd", error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename();
    int descriptor = -1;
    std::from_chars(name.data(), name.data() + name.size(), descriptor);
    const ino_t inode = inode_of(descriptor);
    const bool is_known = std::any_of(connections_.begin(), connections_.end(),
                                      [&](const Connection& known) { return known.inode == inode; });
    if (is_known || !is_connection(descriptor, port_)) continue;
    return &connections_.emplace_back(Connection{descriptor, inode});
  }
  return nullptr;
}

void RequestDeadline::answer(Connection* connection, const std::function<void()>& work) {
  own_ = connection;
  if (own_) {
    const std::lock_guard lock(mutex_);
    own_->since = Clock::now();
    own_->awaited = own_->head_awaited = true;
    changed_.notify_one();
  }
  work();
  own_ = nullptr;
  const std::lock_guard lock(mutex_);
  connections_.remove_if([&](const Connection& one) { return &one == connection; });
}

void RequestDeadline::head_is_here() {
  if (!own_) return;
  const std::lock_guard lock(mutex_);
  own_->head_awaited = false;
}

void RequestDeadline::is_here() {
  if (!own_) return;
  const std::lock_guard lock(mutex_);
  own_->head_awaited = false;
  own_->awaited = false;
}

void RequestDeadline::read_away() {
  if (!own_) return;
  is_here();
  ::shutdown(own_->socket, SHUT_WR);
  std::vector<char> bytes(kReadAtOnce);
  pollfd more{own_->socket, POLLIN, 0};
  for (std::size_t left = kMostAway; left > 0 && ::poll(&more, 1, kPause_ms) > 0;) {
    const ssize_t size = ::recv(own_->socket, bytes.data(), std::min(bytes.size(), left), MSG_DONTWAIT);
    if (size <= 0) return;
    left -= static_cast<std::size_t>(size);
  }
}

bool RequestDeadline::floods(const Connection& one) {
  return one.head_awaited && inode_of(one.socket) == one.inode && bytes_taken(one.socket) > kMostHead;
}

void RequestDeadline::watch() {
  std::unique_lock lock(mutex_);
  while (!ends_) {
    auto next = Clock::time_point::max();
    for (Connection& one : connections_) {
      if (!one.awaited) continue;
      const auto now = Clock::now();
      const bool too_long = floods(one);
      if (one.since + most_ > now && !too_long) {
        next = std::min({next, one.since + most_, one.head_awaited ? now + kLook : Clock::time_point::max()});
        continue;
      }
      one.awaited = one.head_awaited = false;
      if (inode_of(one.socket) != one.inode) continue;  // the library has just closed it
      const std::string_view answer = too_long ? kHeadTooLong : std::string_view(answer_);
      const linger at_once{1, 0};  // a reset; otherwise a client that keeps sending would occupy buffers
      if (too_long) ::setsockopt(one.socket, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
      (void)::send(one.socket, answer.data(), answer.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
      ::shutdown(one.socket, SHUT_RDWR);
    }
    if (next == Clock::time_point::max())
      changed_.wait(lock);
    else
      changed_.wait_until(lock, next);
  }
}

}  // namespace robosim::serve
