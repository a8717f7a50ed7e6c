#include "sim/base/child.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/personality.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <utility>

extern char** environ;

namespace robosim {
namespace {

[[noreturn]] void fail(const std::string& what, int error = errno) {
  throw std::system_error(error, std::generic_category(), what);
}

/// The settings of a posix_spawn() call, and the descriptors that must stay open until the call returns.
struct Instructions {
  posix_spawnattr_t spawn;
  posix_spawn_file_actions_t files;
  std::vector<Descriptor> moved;

  Instructions() {
    ::posix_spawnattr_init(&spawn);
    ::posix_spawn_file_actions_init(&files);
  }
  ~Instructions() {
    ::posix_spawn_file_actions_destroy(&files);
    ::posix_spawnattr_destroy(&spawn);
  }
  Instructions(const Instructions&) = delete;
  Instructions& operator=(const Instructions&) = delete;

  /// Passes the descriptor `fd` to the child as `number` (0, 1, 2).
  void give(int number, int fd) {
    if (fd == ChildStart::kOurs) return;
    if (fd == ChildStart::kNothing) {
      ::posix_spawn_file_actions_addopen(&files, number, "/dev/null", number == 0 ? O_RDONLY : O_WRONLY, 0);
      return;
    }
    // Moves `fd` away from 0, 1 and 2, which the child's own descriptors replace. This process may have been
    // started without standard streams.
    if (fd <= STDERR_FILENO) {
      moved.emplace_back(::fcntl(fd, F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
      fd = moved.back().get();
      if (fd < 0) fail("fcntl");
    }
    ::posix_spawn_file_actions_adddup2(&files, fd, number);
  }

  void set_signals(const ChildStart& start) {
    short flags = 0;
    if (!start.default_signals.empty()) {
      sigset_t none, defaults;
      ::sigemptyset(&none);
      ::sigemptyset(&defaults);
      for (const int number : start.default_signals) ::sigaddset(&defaults, number);
      ::posix_spawnattr_setsigmask(&spawn, &none);
      ::posix_spawnattr_setsigdefault(&spawn, &defaults);
      flags |= POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF;
    }
    if (start.own_group) {
      ::posix_spawnattr_setpgroup(&spawn, 0);
      flags |= POSIX_SPAWN_SETPGROUP;
    }
    ::posix_spawnattr_setflags(&spawn, flags);
  }
};

/// Disables address space randomisation (ASLR) in the programs that this thread starts, during the lifetime
/// of the object. Has no effect if the kernel or a container refuses this setting.
class FixedAddresses {
 public:
  explicit FixedAddresses(bool wanted) : before_(wanted ? ::personality(kQuery) : -1) {
    if (before_ >= 0) ::personality(static_cast<unsigned long>(before_) | ADDR_NO_RANDOMIZE);
  }
  ~FixedAddresses() {
    if (before_ >= 0) ::personality(static_cast<unsigned long>(before_));
  }
  FixedAddresses(const FixedAddresses&) = delete;
  FixedAddresses& operator=(const FixedAddresses&) = delete;

 private:
  static constexpr unsigned long kQuery = 0xffffffff;  // personality(2): returns the setting, changes nothing
  int before_;
};

std::vector<char*> pointers(const std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (const std::string& text : texts) result.push_back(const_cast<char*>(text.c_str()));
  result.push_back(nullptr);
  return result;
}

}  // namespace

Pipe::Pipe() {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) fail("cannot create a pipe");
  read = Descriptor(ends[0]);
  write = Descriptor(ends[1]);
}

std::string Ending::text() const {
  if (signal == 0) return "ended with status " + std::to_string(status);
  return "was ended by signal " + std::to_string(signal) + " (" + ::strsignal(signal) + ")";
}

Child::Child(const ChildStart& start) : own_group_(start.own_group) {
  Instructions how;
  how.moved.reserve(3);
  how.give(STDIN_FILENO, start.input);
  how.give(STDOUT_FILENO, start.output);
  how.give(STDERR_FILENO, start.errors);
  if (!start.folder.empty()) ::posix_spawn_file_actions_addchdir_np(&how.files, start.folder.c_str());
  how.set_signals(start);
  const std::vector<char*> arguments = pointers(start.words);
  const std::vector<char*> variables =
      start.environment ? pointers(*start.environment) : std::vector<char*>{};
  const FixedAddresses fixed(start.fixed_addresses);
  const int error = ::posix_spawnp(&pid_, arguments[0], &how.files, &how.spawn, arguments.data(),
                                   start.environment ? variables.data() : environ);
  if (error != 0) {
    pid_ = -1;
    fail(start.words[0] + " cannot be started", error);
  }
}

Child::Child(const std::function<int()>& work) {
  std::fflush(nullptr);
  pid_ = ::fork();
  if (pid_ < 0) fail("cannot fork");
  if (pid_ == 0) {
    const int status = [&]() noexcept { return work(); }();
    std::fflush(nullptr);
    ::_exit(status);
  }
}

Child::Child(Child&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)), own_group_(other.own_group_), ending_(other.ending_) {}

Child& Child::operator=(Child&& other) noexcept {
  std::swap(pid_, other.pid_);
  std::swap(own_group_, other.own_group_);
  std::swap(ending_, other.ending_);
  return *this;
}

Child::~Child() {
  if (pid_ <= 0) return;
  send(SIGKILL);
  wait();
}

void Child::send(int signal) const {
  if (pid_ > 0) ::kill(own_group_ ? -pid_ : pid_, signal);
}

bool Child::has_ended() const {
  if (pid_ <= 0) return true;
  siginfo_t info{};
  const bool failed = ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) != 0;
  return (failed && errno != EINTR) || info.si_pid != 0;
}

Ending Child::wait() {
  if (pid_ <= 0) return ending_;
  int status = 0;
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  ending_ = WIFSIGNALED(status) ? Ending{0, WTERMSIG(status)} : Ending{WEXITSTATUS(status), 0};
  return ending_;
}

std::string output_of(const std::vector<std::string>& words) {
  std::string output;
  try {
    Pipe pipe;
    ChildStart start;
    start.words = words;
    start.input = start.errors = ChildStart::kNothing;
    start.output = pipe.write.get();
    Child child(start);
    pipe.write.close();
    char buffer[4096];
    for (;;) {
      const ssize_t got = ::read(pipe.read.get(), buffer, sizeof buffer);
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) break;
      output.append(buffer, static_cast<std::size_t>(got));
    }
    child.wait();
  } catch (const std::system_error&) {
    return "";
  }
  return output;
}

}  // namespace robosim
