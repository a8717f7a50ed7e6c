#include "sim/runner/lines.h"

#include <unistd.h>

#include <cerrno>

namespace robosim::runner {

void write_line(const std::string& line) {
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t n = ::write(STDOUT_FILENO, line.data() + done, line.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) ::_exit(0);  // the client has gone
    done += static_cast<std::size_t>(n);
  }
}

std::optional<std::string> read_line(const std::atomic<bool>* interrupted) {
  static std::string unread;
  for (std::size_t searched = 0;;) {
    const std::size_t end = unread.find('\n', searched);
    if (end != std::string::npos) {
      std::string line = unread.substr(0, end);
      unread.erase(0, end + 1);
      return line;
    }
    searched = unread.size();
    if (interrupted && interrupted->load(std::memory_order_relaxed)) return std::nullopt;
    char chunk[4096];
    const ssize_t n = ::read(STDIN_FILENO, chunk, sizeof chunk);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return std::nullopt;
    unread.append(chunk, static_cast<std::size_t>(n));
  }
}

}  // namespace robosim::runner
