#include "sim/client/process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <system_error>
#include <utility>

extern char** environ;

namespace robosim::client {
namespace {

[[noreturn]] void fail(const char* what, int error = errno) {
  throw std::system_error(error, std::generic_category(), what);
}

void close_and_forget(int& fd) {
  if (fd >= 0) ::close(fd);
  fd = -1;
}

struct Descriptor {
  int fd = -1;
  Descriptor() = default;
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close_and_forget(fd); }
  int release() { return std::exchange(fd, -1); }
  /// Out of the way of 0, 1 and 2, which the child is about to get: we may have been started without them.
  void keep_above_standard() {
    if (fd > 2) return;
    const int moved = ::fcntl(fd, F_DUPFD_CLOEXEC, 3);
    if (moved < 0) fail("fcntl");
    ::close(fd);
    fd = moved;
  }
};

struct Attributes {
  posix_spawnattr_t spawn;
  posix_spawn_file_actions_t files;
  Attributes() {
    ::posix_spawnattr_init(&spawn);
    ::posix_spawn_file_actions_init(&files);
  }
  ~Attributes() {
    ::posix_spawn_file_actions_destroy(&files);
    ::posix_spawnattr_destroy(&spawn);
  }
};

long long now_ms() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * 1000LL + now.tv_nsec / 1000000;
}

std::string how_it_ended(int status) {
  if (WIFSIGNALED(status)) {
    const int number = WTERMSIG(status);
    return "was ended by signal " + std::to_string(number) + " (" + ::strsignal(number) + ")";
  }
  return "ended with status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

Process::Process(const std::filesystem::path& program) {
  // Requests go through a socket: writing to a program that died must not raise SIGPIPE in ours.
  int request[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, request) != 0) fail("socketpair");
  Descriptor request_ours, request_theirs;
  request_ours.fd = request[0];
  request_theirs.fd = request[1];
  int answer[2];
  if (::pipe2(answer, O_CLOEXEC) != 0) fail("pipe2");
  Descriptor answer_ours, answer_theirs;
  answer_ours.fd = answer[0];
  answer_theirs.fd = answer[1];
  for (Descriptor* d : {&request_ours, &request_theirs, &answer_ours, &answer_theirs})
    d->keep_above_standard();

  Attributes attributes;
  ::posix_spawn_file_actions_adddup2(&attributes.files, request_theirs.fd, STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&attributes.files, answer_theirs.fd, STDOUT_FILENO);
  sigset_t none, defaults;
  ::sigemptyset(&none);
  ::sigemptyset(&defaults);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGTSTP, SIGWINCH}) {
    ::sigaddset(&defaults, number);
  }
  ::posix_spawnattr_setsigmask(&attributes.spawn, &none);
  ::posix_spawnattr_setsigdefault(&attributes.spawn, &defaults);
  ::posix_spawnattr_setpgroup(&attributes.spawn, 0);
  ::posix_spawnattr_setflags(&attributes.spawn,
                             POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);

  std::string name = program.string();
  char* const arguments[] = {name.data(), nullptr};
  const int error =
      ::posix_spawn(&pid_, name.c_str(), &attributes.files, &attributes.spawn, arguments, environ);
  if (error != 0) fail(("cannot start " + name).c_str(), error);
  requests_ = request_ours.release();
  answers_ = answer_ours.release();
}

Process::~Process() { finish(); }

bool Process::write(std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::send(requests_, text.data(), text.size(), MSG_NOSIGNAL);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

std::optional<std::string_view> Process::read_line(int timeout_ms) {
  const long long began = now_ms();
  long long interrupt_seen = -1;
  std::size_t searched = next_;
  for (;;) {
    const std::size_t end = buffer_.find('\n', searched);
    if (end != std::string::npos) {
      const std::string_view line = std::string_view(buffer_).substr(next_, end - next_);
      next_ = end + 1;
      return line;
    }
    buffer_.erase(0, next_);
    next_ = 0;
    searched = buffer_.size();
    // In slices: a signal that arrives just before poll() does not wake it.
    constexpr long long kPollSlice_ms = 200;
    const long long now = now_ms();
    if (interrupted_ && interrupt_seen < 0) interrupt_seen = now;
    long long left = kPollSlice_ms;
    if (timeout_ms >= 0) left = std::min(left, began + timeout_ms - now);
    if (interrupt_seen >= 0) left = std::min(left, interrupt_seen + kStopPatience_ms - now);
    pollfd ready{answers_, POLLIN, 0};
    const int polled = ::poll(&ready, 1, static_cast<int>(std::max(left, 0LL)));
    if (polled < 0 && errno == EINTR) continue;
    if (polled < 0 || (polled == 0 && left <= 0)) return std::nullopt;
    if (polled == 0) continue;
    constexpr std::size_t kChunk = 65536;
    buffer_.resize(searched + kChunk);
    const ssize_t n = ::read(answers_, buffer_.data() + searched, kChunk);
    const int error = errno;
    buffer_.resize(searched + static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
    if (n < 0 && error == EINTR) continue;
    if (n <= 0) {
      silent_ = true;
      return std::nullopt;
    }
  }
}

void Process::keep_close() const { ::fcntl(answers_, F_SETPIPE_SZ, 1); }

void Process::interrupt() {
  interrupted_ = 1;
  if (pid_ > 0) ::kill(-pid_, SIGINT);
}

void Process::kill() const {
  if (pid_ > 0) ::kill(-pid_, SIGKILL);
}

std::string Process::finish() {
  if (pid_ <= 0) return ending_;
  close_and_forget(requests_);
  constexpr long long kPatience_ms = 1000;
  const long long deadline = now_ms() + kPatience_ms;
  while (read_line(static_cast<int>(std::max(0LL, deadline - now_ms())))) {
  }
  // Wait without reaping: as long as the zombie is there, nobody else gets its number, and the signal can
  // only meet what the program forked.
  siginfo_t info{};
  for (;;) {
    info.si_pid = 0;
    const bool failed = ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) != 0;
    if ((failed && errno != EINTR) || info.si_pid != 0 || now_ms() >= deadline) break;
    const timespec pause{0, 500'000};
    ::nanosleep(&pause, nullptr);
  }
  ::kill(-pid_, SIGKILL);
  int status = 0;
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  close_and_forget(answers_);
  pid_ = -1;
  return ending_ = how_it_ended(status);
}

}  // namespace robosim::client
