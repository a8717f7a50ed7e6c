// Runs the built robosim command on a separate terminal.
#pragma once

#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "tests/system/command.h"

namespace robosim::test {

// A guard for tests that fail: they end instead of waiting for ever.
constexpr int kSilence_ms = 30'000;

/// The command with a terminal of its own, of which we are the far end.
class OnTerminal {
 public:
  OnTerminal(std::vector<std::string> words, unsigned short columns, unsigned short rows) {
    words.insert(words.begin(), ROBOSIM_COMMAND);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const winsize size{rows, columns, 0, 0};
    pid_ = ::forkpty(&terminal_, nullptr, nullptr, &size);
    if (pid_ == 0) {
      ::setenv("LC_ALL", "C.UTF-8", 1);
      ::setenv("TERM", "xterm", 1);
      ::execv(ROBOSIM_COMMAND, arguments.data());
      ::_exit(127);
    }
  }
  ~OnTerminal() {
    if (pid_ > 0) {
      ::kill(pid_, SIGKILL);
      ::waitpid(pid_, nullptr, 0);
    }
    ::close(terminal_);
  }

  /// Reads on until `text` has appeared after the last thing waited for; false at the end, or when nothing
  /// comes any more. The view writes changes only: a text is found if all its characters are new, or of
  /// another colour.
  bool wait_for(const std::string& text) {
    for (;;) {
      const auto found = seen_.find(text, from_);
      if (found != std::string::npos) {
        from_ = found + text.size();
        return true;
      }
      pollfd ready{terminal_, POLLIN, 0};
      if (::poll(&ready, 1, kSilence_ms) == 0) return false;
      char chunk[4096];
      const ssize_t n = ::read(terminal_, chunk, sizeof chunk);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return false;  // Linux: EIO when the other end is closed
      seen_.append(chunk, static_cast<std::size_t>(n));
    }
  }
  void type(const std::string& keys) {
    if (::write(terminal_, keys.data(), keys.size()) < 0)
      throw std::system_error(errno, std::generic_category());
  }
  void resize(unsigned short columns, unsigned short rows) {
    const winsize size{rows, columns, 0, 0};
    ::ioctl(terminal_, TIOCSWINSZ, &size);  // the kernel sends SIGWINCH
  }
  void signal(int number) { ::kill(pid_, number); }
  bool is_raw() const {
    termios settings{};
    ::tcgetattr(terminal_, &settings);
    return (settings.c_lflag & ICANON) == 0;
  }
  /// Reads to the end. The exit status.
  int finish() {
    wait_for("\001 never written");
    int status = 0;
    ::waitpid(pid_, &status, 0);
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  const std::string& seen() const { return seen_; }

 private:
  int terminal_ = -1;
  pid_t pid_ = -1;
  std::string seen_;
  std::size_t from_ = 0;
};

}  // namespace robosim::test
