// Shows one line of progress on a terminal's standard error. Shows nothing in a pipe.
#pragma once

#include <cstdint>
#include <string>

#include "sim/base/progress.h"

namespace robosim::terminal {

class Progress final : public robosim::Progress {
 public:
  /// Stays silent if standard error is not a terminal, or if `wanted` is false.
  explicit Progress(bool wanted);
  ~Progress() override;
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  bool active() const { return active_; }
  /// Shows a line immediately.
  void say(const std::string& text) override;
  /// Shows a line that changes often. Shows nothing in the first half second of this object's life, and then
  /// at most ten lines a second.
  void update(const std::string& text) override;
  /// Shows simulated time in a line that changes often.
  void advance(std::int64_t t_us, double for_s);
  /// Clears the line.
  void clear() override;

 private:
  bool due();

  bool active_;
  bool shown_ = false;
  std::int64_t next_us_;
};

}  // namespace robosim::terminal
