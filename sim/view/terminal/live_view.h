// Shows a run in the terminal during the run.
#pragma once

#include <functional>
#include <string>

#include "sim/view/terminal/live_scene.h"
#include "sim/view/terminal/pacer.h"
#include "sim/view/terminal/terminal.h"
#include "sim/wire/messages.h"

namespace robosim::terminal {

/// The sample period of a live view, in simulated time.
constexpr std::int64_t kViewEvery_ns = 10'000'000;

/// Occupies the terminal from construction to destruction. While it waits for the wall clock,
/// on_event() does not return, so that the runner blocks on its full pipe.
class LiveView {
 public:
  struct Options {
    double speed = 1.0;  ///< simulated seconds per second of wall time; 0 = as fast as possible
    Look look;
    std::function<bool()> stopped;  ///< returns whether the user has pressed Ctrl-C, which ends all waiting
    std::function<void()> quit;     ///< called when `q` is pressed: ends the run
  };

  LiveView(LiveScene& scene, Options options);

  void on_event(const wire::Event& event);
  /// Shows the verdict, and waits for a key if there is a keyboard.
  void finish(const result::RunResult& result);

 private:
  void handle(Key key);
  void draw(std::int64_t wall_us);
  bool leaving() const { return quit_ || options_.stopped(); }

  LiveScene& scene_;
  Options options_;
  Pacer pacer_;
  std::int64_t last_drawn_us_ = -1'000'000'000;
  bool changed_ = true;
  bool quit_ = false;
  Screen screen_;
};

}  // namespace robosim::terminal
