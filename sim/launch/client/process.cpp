#include "sim/launch/client/process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <system_error>
#include <utility>

#include "sim/base/wall_clock.h"

namespace robosim::client {
namespace {

[[noreturn]] void fail(const char* what, int error = errno) {
  throw std::system_error(error, std::generic_category(), what);
}

std::int64_t now_ms() { return wall_us() / 1000; }

Child start(const std::filesystem::path& program, int input, int output) {
  ChildStart start;
  start.words = {program.has_parent_path() ? program.string() : "./" + program.string()};
  start.input = input;
  start.output = output;
  start.default_signals = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGTSTP, SIGWINCH};
  start.own_group = true;
  start.fixed_addresses = true;  // a sketch on the host can read addresses; they must not differ between runs
  return Child(start);
}

}  // namespace

struct Process::Ends {
  std::filesystem::path program;
  Descriptor requests, its_requests;
  Pipe answers;

  explicit Ends(std::filesystem::path name) : program(std::move(name)) {
    // Requests go through a socket, since a write to a dead program must not raise SIGPIPE in this process.
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) fail("socketpair");
    requests = Descriptor(ends[0]);
    its_requests = Descriptor(ends[1]);
  }
};

Process::Process(const std::filesystem::path& program) : Process(Ends(program)) {}

Process::Process(Ends ends)
    : requests_(std::move(ends.requests)),
      answers_(std::move(ends.answers.read)),
      child_(start(ends.program, ends.its_requests.get(), ends.answers.write.get())) {}

Process::~Process() { finish(); }

bool Process::write(std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::send(requests_.get(), text.data(), text.size(), MSG_NOSIGNAL);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

bool Process::read_more(Patience& patience) {
  buffer_.erase(0, next_);
  next_ = 0;
  for (;;) {
    // Polls in slices, since a signal that arrives just before poll() does not wake it.
    constexpr std::int64_t kPollSlice_ms = 200;
    const std::int64_t now = now_ms();
    if (interrupted_ && patience.interrupt_seen_ms < 0) patience.interrupt_seen_ms = now;
    std::int64_t left = kPollSlice_ms;
    if (patience.until_ms >= 0) left = std::min(left, patience.until_ms - now);
    if (patience.interrupt_seen_ms >= 0)
      left = std::min(left, patience.interrupt_seen_ms + kStopPatience_ms - now);
    pollfd ready{answers_.get(), POLLIN, 0};
    const int polled = ::poll(&ready, 1, static_cast<int>(std::max(left, std::int64_t{0})));
    if (polled < 0 && errno == EINTR) continue;
    if (polled < 0 || (polled == 0 && left <= 0)) return false;
    if (polled == 0) continue;
    const ssize_t n = ::read(answers_.get(), chunk_.data(), chunk_.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      silent_ = true;
      return false;
    }
    buffer_.append(chunk_.data(), static_cast<std::size_t>(n));
    return true;
  }
}

std::optional<std::string_view> Process::read_line(int timeout_ms) {
  Patience patience{timeout_ms < 0 ? -1 : now_ms() + timeout_ms};
  for (std::size_t searched = 0;;) {
    const std::size_t end = buffer_.find('\n', next_ + searched);
    if (end != std::string::npos) {
      const std::string_view line = std::string_view(buffer_).substr(next_, end - next_);
      next_ = end + 1;
      return line;
    }
    searched = buffer_.size() - next_;
    if (!read_more(patience)) return std::nullopt;
  }
}

std::optional<std::string_view> Process::read_bytes(std::size_t count) {
  for (Patience patience{-1}; buffer_.size() - next_ < count;)
    if (!read_more(patience)) return std::nullopt;
  const std::string_view bytes = std::string_view(buffer_).substr(next_, count);
  next_ += count;
  return bytes;
}

void Process::keep_close() const { ::fcntl(answers_.get(), F_SETPIPE_SZ, 1); }

void Process::interrupt() {
  interrupted_ = 1;
  child_.send(SIGINT);
}

void Process::kill() const { child_.send(SIGKILL); }

std::string Process::finish() {
  if (std::exchange(finished_, true)) return child_.wait().text();
  requests_.close();
  constexpr std::int64_t kPatience_ms = 1000;
  const std::int64_t deadline = now_ms() + kPatience_ms;
  while (read_line(static_cast<int>(std::max(std::int64_t{0}, deadline - now_ms())))) {
  }
  // The kernel does not reuse the process id until this process waits for the program. Therefore the signal
  // reaches only the program and its forks.
  while (!child_.has_ended() && now_ms() < deadline) {
    const timespec pause{0, 500'000};
    ::nanosleep(&pause, nullptr);
  }
  child_.send(SIGKILL);
  answers_.close();
  return child_.wait().text();
}

}  // namespace robosim::client
