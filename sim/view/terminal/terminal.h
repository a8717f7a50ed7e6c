// Provides the terminal: its properties, and full-screen mode.
#pragma once

#include <termios.h>

#include <optional>
#include <string>
#include <string_view>

#include "sim/view/terminal/frame.h"

namespace robosim::terminal {

struct TerminalSize {
  int columns = 80;
  int rows = 24;
  bool operator==(const TerminalSize&) const = default;
};

/// Returns the size of the terminal behind a descriptor; nothing if it is not a terminal.
std::optional<TerminalSize> terminal_size(int fd);

/// The user's keys.
enum class Key { none, space, plus, minus, quit, follow, up, down, left, right, other };

/// Removes a key from the front of a terminal's input, `bytes`, and returns it. Does not remove an incomplete
/// escape sequence.
Key take_key(std::string& bytes);

/// A key, for callers that also need letters.
struct Press {
  enum class Kind : unsigned char {
    nothing,    ///< timeout
    character,  ///< `character`: printable ASCII, or a byte of UTF-8
    enter,
    erase,
    up,
    down,
    left,
    right,
    other,
    end,       ///< no further input: end of file, Ctrl-D, or the terminal is gone
    interrupt  ///< Ctrl-C, or another signal that requests the program's end
  };
  Kind kind = Kind::nothing;
  char character = 0;
  bool operator==(const Press&) const = default;
};
Press take_press(std::string& bytes);

/// Full-screen mode, from construction to destruction: alternate screen, no cursor, keys unbuffered and not
/// echoed. Afterwards the terminal is restored, even if the process dies of a fault (SIGSEGV, SIGABRT, …).
/// Ctrl-Z also restores it, until the process continues. Only one Screen may exist at a time.
class Screen {
 public:
  /// `output` must be a terminal. Keys are read from `input` if `input` is also a terminal.
  Screen(int input, int output, Look look);
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  TerminalSize size() const;
  bool has_keys() const { return has_keys_; }
  /// Writes the changes since the previous frame.
  void show(const Frame& frame);
  /// Waits at most `timeout_ms` for a key. Returns `none` on a timeout, a signal or a resize.
  Key wait_key(int timeout_ms);
  /// Waits for a key, including letters. Returns `end` once there is no keyboard any more.
  Press wait_press(int timeout_ms);
  /// Returns whether, since the last call, the window was resized or the process continued after a stop.
  bool take_resized();

 private:
  void enter();
  void leave();
  void handle_stop();
  void read_bytes(int timeout_ms);

  int input_, output_;
  Look look_;
  bool has_keys_;
  bool raw_ = false;  // the terminal sends single keys, without echo
  Frame shown_{0, 0};
  std::string bytes_;  // input that is not recognised yet
};

}  // namespace robosim::terminal
