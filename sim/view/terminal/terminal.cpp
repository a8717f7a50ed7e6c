#include "sim/view/terminal/terminal.h"

#include <poll.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <utility>

#include "sim/base/descriptor.h"

namespace robosim::terminal {
namespace {

constexpr std::string_view kEnter = "\033[?1049h\033[?25l\033[0m\033[2J\033[H";
constexpr std::string_view kLeave = "\033[0m\033[?25h\033[?1049l";

constexpr std::array kFaults = {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV};

// State that the signal handlers use.
volatile sig_atomic_t resized = 0;
volatile sig_atomic_t stop_asked = 0;
int restore_input = -1;
int restore_output = -1;
termios before_us;

std::array<struct sigaction, kFaults.size()> faults_before;
struct sigaction resize_before, stop_before;

extern "C" void on_resize(int) { resized = 1; }
extern "C" void on_stop(int) { stop_asked = 1; }
extern "C" void on_fault(int number) {
  write_all(restore_output, kLeave);
  if (restore_input >= 0) ::tcsetattr(restore_input, TCSANOW, &before_us);
  ::raise(number);  // SA_RESETHAND: runs the default action now
}

void handle(int number, void (*handler)(int), int flags, struct sigaction* before) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  ::sigemptyset(&action.sa_mask);
  ::sigaction(number, &action, before);
}

}  // namespace

std::optional<TerminalSize> terminal_size(int fd) {
  if (!::isatty(fd)) return std::nullopt;
  winsize size{};
  if (::ioctl(fd, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) return TerminalSize{};
  return TerminalSize{size.ws_col, size.ws_row};
}

Key take_key(std::string& bytes) {
  constexpr std::string_view kArrows = "ABCD";
  constexpr Key kKeys[] = {Key::up, Key::down, Key::right, Key::left};
  if (bytes.empty()) return Key::none;
  if (bytes[0] == '\033' && bytes.size() > 1 && (bytes[1] == '[' || bytes[1] == 'O')) {
    // Matches the sequences `ESC [ PARAMETERS LETTER` and `ESC O LETTER`.
    const std::size_t end = bytes.find_first_not_of("0123456789;", 2);
    if (end == std::string::npos) return Key::none;
    const std::size_t which = kArrows.find(bytes[end]);
    bytes.erase(0, end + 1);
    return which == std::string_view::npos ? Key::other : kKeys[which];
  }
  if (bytes == "\033") return Key::none;  // the rest may still arrive
  const char c = bytes[0];
  bytes.erase(0, 1);
  switch (c) {
    case ' ':
      return Key::space;
    case '+':
    case '=':
      return Key::plus;
    case '-':
    case '_':
      return Key::minus;
    case 'q':
    case 'Q':
      return Key::quit;
    case 'f':
    case 'F':
      return Key::follow;
    default:
      return Key::other;
  }
}

Press take_press(std::string& bytes) {
  using Kind = Press::Kind;
  if (bytes.empty()) return {};
  if (bytes[0] == '\033') {
    if (bytes.size() > 1 && bytes[1] != '[' && bytes[1] != 'O') {
      bytes.erase(0, 1);
      return {Kind::other};
    }
    switch (take_key(bytes)) {
      case Key::up:
        return {Kind::up};
      case Key::down:
        return {Kind::down};
      case Key::left:
        return {Kind::left};
      case Key::right:
        return {Kind::right};
      case Key::none:
        return {};
      default:
        return {Kind::other};
    }
  }
  const char c = bytes[0];
  bytes.erase(0, 1);
  if (c == '\n' || c == '\r') return {Kind::enter};
  if (c == '\b' || c == 0x7F) return {Kind::erase};
  if (c == 4) return {Kind::end};
  if (static_cast<unsigned char>(c) >= ' ') return {Kind::character, c};
  return {Kind::other};
}

Screen::Screen(int input, int output, Look look)
    : input_(input), output_(output), look_(look), has_keys_(::isatty(input) != 0) {
  if (has_keys_ && ::tcgetattr(input_, &before_us) != 0) has_keys_ = false;
  restore_input = has_keys_ ? input_ : -1;
  restore_output = output_;
  handle(SIGWINCH, on_resize, 0, &resize_before);
  handle(SIGTSTP, on_stop, 0, &stop_before);
  for (std::size_t i = 0; i < kFaults.size(); ++i) {
    handle(kFaults[i], on_fault, static_cast<int>(SA_RESETHAND | SA_NODEFER), &faults_before[i]);
  }
  enter();
}

Screen::~Screen() {
  leave();
  for (std::size_t i = 0; i < kFaults.size(); ++i) ::sigaction(kFaults[i], &faults_before[i], nullptr);
  ::sigaction(SIGTSTP, &stop_before, nullptr);
  ::sigaction(SIGWINCH, &resize_before, nullptr);
}

void Screen::enter() {
  if (has_keys_) {
    termios raw = before_us;
    raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);  // keeps ISIG: Ctrl-C is a signal
    raw.c_cc[VMIN] = 0;
    raw.c_cc[VTIME] = 0;
    ::tcsetattr(input_, TCSANOW, &raw);
    raw_ = true;
  }
  write_all(output_, kEnter);
  shown_ = Frame(0, 0);
}

void Screen::leave() {
  write_all(output_, kLeave);
  if (std::exchange(raw_, false)) ::tcsetattr(input_, TCSANOW, &before_us);
}

TerminalSize Screen::size() const { return terminal_size(output_).value_or(TerminalSize{}); }

void Screen::show(const Frame& frame) {
  const std::string bytes = changes(shown_, frame, look_);
  if (!bytes.empty()) write_all(output_, bytes);
  shown_ = frame;
}

void Screen::read_bytes(int timeout_ms) {
  pollfd ready{input_, POLLIN, 0};
  const int polled = ::poll(&ready, has_keys_ ? 1 : 0, timeout_ms);
  if (stop_asked) handle_stop();
  if (polled <= 0) return;
  char chunk[64];
  const ssize_t n = ::read(input_, chunk, sizeof chunk);
  if (n > 0) {
    bytes_.append(chunk, static_cast<std::size_t>(n));
  } else if (n == 0) {
    // Nothing was read: Ctrl-C discarded the input, or the terminal hung up. After a hang-up, further polling
    // would be a busy loop.
    has_keys_ = (ready.revents & (POLLHUP | POLLERR | POLLNVAL)) == 0;
  } else if (errno != EINTR) {
    has_keys_ = false;
  }
}

Key Screen::wait_key(int timeout_ms) {
  if (const Key key = take_key(bytes_); key != Key::none) return key;
  read_bytes(timeout_ms);
  return take_key(bytes_);
}

Press Screen::wait_press(int timeout_ms) {
  if (const Press press = take_press(bytes_); press.kind != Press::Kind::nothing) return press;
  if (!has_keys_) return {Press::Kind::end};
  read_bytes(timeout_ms);
  return take_press(bytes_);
}

bool Screen::take_resized() {
  const bool was = resized != 0;
  resized = 0;
  return was;
}

void Screen::handle_stop() {
  stop_asked = 0;
  leave();
  struct sigaction ours {};
  handle(SIGTSTP, SIG_DFL, 0, &ours);
  ::raise(SIGTSTP);  // returns when the user continues this process
  ::sigaction(SIGTSTP, &ours, nullptr);
  enter();
  resized = 1;
}

}  // namespace robosim::terminal
