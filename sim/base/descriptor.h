// Manages file descriptors of files, pipes, sockets and locks.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>
#include <system_error>
#include <utility>

namespace robosim {

/// Owns a file descriptor, and closes it on destruction.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~Descriptor() { close(); }

  bool is_open() const { return fd_ >= 0; }
  int get() const { return fd_; }
  void close() {
    if (is_open()) ::close(fd_);
    fd_ = -1;
  }

 private:
  int fd_ = -1;
};

/// Returns a descriptor for the open file of `fd`, with a number of at least `least`. Throws
/// std::system_error.
inline Descriptor at_least(int least, Descriptor fd) {
  if (fd.get() >= least) return fd;
  Descriptor moved(::fcntl(fd.get(), F_DUPFD_CLOEXEC, least));
  // EINVAL means that `least` exceeds the limit of descriptors.
  if (!moved.is_open())
    throw std::system_error(errno == EINVAL ? EMFILE : errno, std::generic_category(), "no descriptor");
  return moved;
}

/// Writes all bytes, and continues after signals. Returns 0, or the errno of a failure, after which some
/// bytes may have been written. Safe in a signal handler.
inline int write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return 0;
}

}  // namespace robosim
