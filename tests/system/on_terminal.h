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

// Time without output after which a test fails instead of waiting forever.
constexpr int kSilence_ms = 30'000;

/// The command on a separate terminal. This process is the terminal's other end.
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

  /// Reads until `text` has appeared after the previous match. Returns false at the end of the output, or
  /// after a long silence. The view writes only changed characters. Therefore each character
  /// of `text` must be new, or must have changed its colour.
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
      if (n <= 0) return false;  // Linux reports EIO when the other end is closed
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
  /// Reads to the end. Returns the exit status.
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
