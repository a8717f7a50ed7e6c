// Where a session meets a person: frames one way, keys the other. A pipe is a person who types blindly.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "sim/tui/frame.h"
#include "sim/tui/terminal.h"

namespace robosim::tui {

class Console {
 public:
  virtual ~Console() = default;
  virtual TerminalSize size() = 0;
  virtual Look look() const = 0;
  /// Whether somebody looks on: then walks are shown move by move. Otherwise only frames that wait for an
  /// answer are, and no time passes.
  virtual bool is_live() const = 0;
  virtual void show(const Frame& frame) = 0;
  /// The next key; `nothing` after so many ms, at the latest, and after a resize (draw again). Below 0: as
  /// long as it takes, but `nothing` may come all the same.
  virtual Press wait(int timeout_ms) = 0;
  /// A clock for pacing, microseconds.
  virtual std::int64_t now_us() = 0;
  /// Calls `use` with the terminal as it was before the console took it.
  virtual void lend(const std::function<void()>& use) = 0;
};

/// The whole screen of a terminal that can address its cursor. In a window too small it says so, and no key
/// but q does anything.
class ScreenConsole final : public Console {
 public:
  static constexpr TerminalSize kLeast{40, 14};

  /// `stopped`: whether the user wants out (a signal came).
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

/// Lines of text, for pipes and terminals that can do no more (TERM=dumb). What comes in is read as keys,
/// the end of a line as Enter. A frame is written when an answer is needed and the last line is used up.
class LineConsole final : public Console {
 public:
  /// Descriptors. Nothing is written but text: no escape sequences.
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
  bool in_line_ = false;  ///< some of a line has been read, but not its end
  bool ended_ = false;
};

}  // namespace robosim::tui
