#include "sim/view/terminal/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "sim/base/terminal_text.h"
#include "sim/base/wall_clock.h"
#include "sim/view/terminal/text.h"

namespace robosim::terminal {
namespace {

constexpr std::int64_t kQuiet_us = 500'000;
constexpr std::int64_t kEvery_us = 100'000;

// Ignores errors: the loss of the terminal is not a reason to stop.
void put_on_terminal(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

}  // namespace

Progress::Progress(bool wanted)
    : active_(wanted && ::isatty(STDERR_FILENO) != 0), next_us_(active_ ? wall_us() + kQuiet_us : 0) {}

Progress::~Progress() { clear(); }

void Progress::say(const std::string& text) {
  if (!active_) return;
  put_on_terminal("\r\033[K" + in_one_line(text));
  shown_ = true;
}

bool Progress::due() {
  if (!active_) return false;
  const std::int64_t now = wall_us();
  if (now < next_us_) return false;
  next_us_ = now + kEvery_us;
  return true;
}

void Progress::update(const std::string& text) {
  if (due()) say(text);
}

void Progress::advance(std::int64_t t_us, double for_s) {
  if (!due()) return;
  say(fmt::format("simulated: {} of at most {}", time_text(static_cast<double>(t_us) * 1e-6),
                  time_text(for_s)));
}

void Progress::clear() {
  if (!shown_) return;
  put_on_terminal("\r\033[K");
  shown_ = false;
}

}  // namespace robosim::terminal
