#include "sim/view/terminal/live_view.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>

#include "sim/base/wall_clock.h"

namespace robosim::terminal {
namespace {

constexpr std::int64_t kFrame_us = 1'000'000 / 30;
constexpr int kEndLook_ms = 200;  // at the end: longest delay until a resize or a signal is noticed

std::string speed_text(const Pacer& pacer) {
  if (pacer.paused()) return "paused";
  return pacer.speed() <= 0.0 ? "as fast as possible" : fmt::format("×{}", pacer.speed());
}

}  // namespace

LiveView::LiveView(LiveScene& scene, Options options)
    : scene_(scene),
      options_(std::move(options)),
      pacer_(options_.speed),
      screen_(STDIN_FILENO, STDOUT_FILENO, options_.look) {}

void LiveView::on_event(const wire::Event& event) {
  scene_.add(event);
  changed_ = true;
  const auto* sample = std::get_if<wire::Sample>(&event);
  if (!sample) return;
  while (!leaving()) {
    const std::int64_t now = wall_us();
    const std::int64_t wait = pacer_.paused() ? kFrame_us : pacer_.wait_us(sample->t_us, now);
    changed_ |= screen_.take_resized();
    const std::int64_t next_frame = std::max<std::int64_t>(last_drawn_us_ + kFrame_us - now, 0);
    if (changed_ && next_frame == 0) {
      draw(now);
      handle(screen_.wait_key(0));
      continue;
    }
    if (wait == 0) return;
    // May wait up to one millisecond longer, because poll() uses whole milliseconds.
    const std::int64_t pause = changed_ ? std::min(wait, next_frame) : wait;
    handle(screen_.wait_key(static_cast<int>(pause / 1000 + 1)));
  }
}

void LiveView::finish(const result::RunResult& result) {
  scene_.finish(result);
  do {
    draw(wall_us());
    if (leaving() || !screen_.has_keys()) return;
  } while (screen_.wait_key(kEndLook_ms) == Key::none);
}

void LiveView::handle(Key key) {
  if (key == Key::none) return;
  switch (key) {
    case Key::space:
      pacer_.set_paused(!pacer_.paused());
      break;
    case Key::plus:
      pacer_.faster();
      break;
    case Key::minus:
      pacer_.slower();
      break;
    case Key::up:
      scene_.scroll(0, -1);
      break;
    case Key::down:
      scene_.scroll(0, 1);
      break;
    case Key::left:
      scene_.scroll(-1, 0);
      break;
    case Key::right:
      scene_.scroll(1, 0);
      break;
    case Key::follow:
      scene_.follow();
      break;
    case Key::quit:
      quit_ = true;
      options_.quit();
      break;
    case Key::none:
    case Key::other:
      break;
  }
  changed_ = true;
}

void LiveView::draw(std::int64_t wall_us) {
  const TerminalSize size = screen_.size();
  screen_.show(scene_.draw(size.columns, size.rows, speed_text(pacer_), options_.look));
  last_drawn_us_ = wall_us;
  changed_ = false;
}

}  // namespace robosim::terminal
