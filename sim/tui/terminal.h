// The terminal: its properties, and full-screen mode.
#pragma once

#include <termios.h>

#include <optional>
#include <string>
#include <string_view>

#include "sim/tui/frame.h"

namespace robosim::tui {

struct TerminalSize {
  int columns = 80;
  int rows = 24;
  bool operator==(const TerminalSize&) const = default;
};

/// The size of the terminal behind a descriptor; nothing if it is none.
std::optional<TerminalSize> terminal_size(int fd);

/// What a user pressed.
enum class Key { none, space, plus, minus, quit, follow, up, down, left, right, other };

/// Takes keys from the front of what a terminal sent: `bytes` loses what was understood. An escape sequence
/// that is not complete yet stays.
Key take_key(std::string& bytes);

/// The same, for callers that also want letters.
struct Press {
  enum class Kind : unsigned char {
    nothing,    ///< none came in time
    character,  ///< `character`: printable ASCII, or a byte of UTF-8
    enter,
    erase,
    up,
    down,
    left,
    right,
    other,
    end,       ///< no more will come: end of the input, Ctrl-D, the terminal is gone
    interrupt  ///< Ctrl-C, or another signal that asks the program to end
  };
  Kind kind = Kind::nothing;
  char character = 0;
  bool operator==(const Press&) const = default;
};
Press take_press(std::string& bytes);

/// Full-screen mode, from construction to destruction: alternate screen, no cursor, keys unbuffered and not
/// echoed. Afterwards the terminal is as it was, also when the process dies of a fault (SIGSEGV, SIGABRT, …)
/// or is stopped by Ctrl-Z and goes on. There can be one at a time.
class Screen {
 public:
  /// `output` must be a terminal; keys come from `input` if that is one too.
  Screen(int input, int output, Look look);
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  TerminalSize size() const;
  bool has_keys() const { return has_keys_; }
  /// Writes what changed since the last frame.
  void show(const Frame& frame);
  /// Waits at most so long for a key; gives none after that, after a signal, and after a resize.
  Key wait_key(int timeout_ms);
  /// The same with letters; `end` once there is no keyboard any more.
  Press wait_press(int timeout_ms);
  /// Whether the window was resized, or the process continued after a stop, since the last call.
  bool take_resized();

 private:
  void enter();
  void leave();
  void handle_stop();
  void read_bytes(int timeout_ms);

  int input_, output_;
  Look look_;
  bool has_keys_;
  bool raw_ = false;  // the terminal gives keys one by one, unseen
  Frame shown_{0, 0};
  std::string bytes_;  // keys not understood yet
};

}  // namespace robosim::tui
