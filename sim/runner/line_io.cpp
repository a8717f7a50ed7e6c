#include "sim/runner/line_io.h"

#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "sim/runner/sandbox_proxy.h"

namespace robosim::runner {
namespace {

const SandboxProxy* way = nullptr;
std::string unread;

ssize_t read_some(char* to, std::size_t bytes) {
  return way ? way->read_some(to, bytes) : ::read(STDIN_FILENO, to, bytes);
}

}  // namespace

void route_through(const SandboxProxy& proxy) {
  way = &proxy;
  unread.clear();
}

std::string take_unread() { return std::exchange(unread, ""); }

void write_line(const std::string& line) {
  if (way) return way->tell(line);
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t n = ::write(STDOUT_FILENO, line.data() + done, line.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) ::_exit(0);  // the client has disconnected
    done += static_cast<std::size_t>(n);
  }
}

void write_batch(std::string_view line, std::string_view bytes) {
  while (!line.empty() || !bytes.empty()) {
    const iovec parts[] = {{const_cast<char*>(line.data()), line.size()},
                           {const_cast<char*>(bytes.data()), bytes.size()}};
    const ssize_t n = ::writev(STDOUT_FILENO, parts, 2);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) ::_exit(0);  // the client has disconnected
    const std::size_t of_line = std::min(line.size(), static_cast<std::size_t>(n));
    line.remove_prefix(of_line);
    bytes.remove_prefix(static_cast<std::size_t>(n) - of_line);
  }
}

std::optional<std::string> read_line(const std::atomic<bool>* interrupted) {
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
    const ssize_t n = read_some(chunk, sizeof chunk);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return std::nullopt;
    unread.append(chunk, static_cast<std::size_t>(n));
  }
}

}  // namespace robosim::runner
