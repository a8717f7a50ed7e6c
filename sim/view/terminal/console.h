// Shows the frames of a session, and reads its keys. Input from a pipe may contain answers to questions that
// have not been shown yet.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "sim/view/terminal/frame.h"
#include "sim/view/terminal/terminal.h"

namespace robosim::terminal {

class Console {
 public:
  virtual ~Console() = default;
  virtual TerminalSize size() = 0;
  virtual Look look() const = 0;
  /// Returns whether a user is watching. If so, a robot's moves are shown one by one. Otherwise only frames
  /// that wait for an answer are shown, without delays.
  virtual bool is_live() const = 0;
  virtual void show(const Frame& frame) = 0;
  /// Returns the next key, or `nothing` after at most `timeout_ms`. A negative `timeout_ms` means no limit.
  /// The result may be `nothing` at any time, for example after a resize: redraw, and call this again.
  virtual Press wait(int timeout_ms) = 0;
  /// Returns the time of a clock for pacing, in microseconds.
  virtual std::int64_t now_us() = 0;
  /// Calls `use` with the terminal in its original state.
  virtual void lend(const std::function<void()>& use) = 0;
};

/// The whole screen of a terminal with cursor addressing. If the window is too small, shows a message, and
/// accepts only q.
class ScreenConsole final : public Console {
 public:
  static constexpr TerminalSize kLeast{40, 14};

  /// `stopped` returns whether a signal has requested the end.
  ScreenConsole(Look look, std::function<bool()> stopped);

  TerminalSize size() override { return screen_->size(); }
  Look look() const override { return look_; }
  bool is_live() const override { return true; }
  void show(const Frame& frame) override;
  Press wait(int timeout_ms) override;
  std::int64_t now_us() override;
  void lend(const std::function<void()>& use) override;

 private:
  bool is_too_small();

  Look look_;
  std::function<bool()> stopped_;
  std::optional<Screen> screen_;
};

/// Lines of text, for pipes and for terminals without other features (TERM=dumb). Each character of the input
/// is a key, and the end of a line is Enter. A frame is written when an answer is needed and the last input
/// line is used up.
class LineConsole final : public Console {
 public:
  /// Reads and writes these file descriptors. Writes only text, without escape sequences.
  LineConsole(int input, int output, Look look);

  TerminalSize size() override { return {80, 60}; }
  Look look() const override { return look_; }
  bool is_live() const override { return false; }
  void show(const Frame& frame) override { pending_ = frame; }
  Press wait(int timeout_ms) override;
  std::int64_t now_us() override { return 0; }
  void lend(const std::function<void()>& use) override;

 private:
  void flush();

  int input_, output_;
  Look look_;
  Frame pending_{0, 0};
  std::string shown_;
  std::string bytes_;
  bool in_line_ = false;  ///< only a part of the present line has been read
  bool ended_ = false;
};

}  // namespace robosim::terminal
