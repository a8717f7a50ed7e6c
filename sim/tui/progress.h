// One line of progress on a terminal's standard error; nothing in a pipe.
#pragma once

#include <cstdint>
#include <string>

namespace robosim::tui {

class Progress {
 public:
  /// Silent if standard error is not a terminal or `wanted` is false.
  explicit Progress(bool wanted);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  bool active() const { return active_; }
  /// Shows a line immediately.
  void say(const std::string& text);
  /// Shows a line that changes often: ten times a second at most, and nothing in the first half second.
  void update(const std::string& text);
  /// Shows simulated time as such a line.
  void advance(std::int64_t t_us, double for_s);
  /// Wipes the line.
  void clear();

 private:
  bool due();

  bool active_;
  bool shown_ = false;
  std::int64_t next_us_;
};

}  // namespace robosim::tui
