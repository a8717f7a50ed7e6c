// Shows a robot that moves from cell to cell, one move after the other.
#include <fmt/format.h>

#include <algorithm>

#include "sim/view/play/session.h"
#include "sim/view/terminal/text.h"

namespace robosim::play {
namespace {

using Kind = terminal::Press::Kind;

constexpr double kSlowest = 0.5;  // moves per second
constexpr double kFastest = 2000.0;
constexpr std::int64_t kFrame_us = 1'000'000 / 30;
// Number of moves between two checks for a key or a signal, after the user has asked to end a walk.
constexpr std::uint64_t kLookEvery_moves = 4096;

}  // namespace

std::string Session::pace_text() const {
  if (paused_) return "paused";
  return pace_ <= 0.0 ? "as fast as possible" : fmt::format("{:.3g} moves a second", pace_);
}

void Session::obey(const terminal::Press& press) {
  if (press.kind == Kind::interrupt) throw SessionQuit{true};
  if (press.kind == Kind::end) throw SessionQuit{};
  if (press.kind == Kind::right) paused_ = single_ = true;
  if (press.kind == Kind::enter) to_the_end_ = true;
  if (press.kind != Kind::character) return;
  due_us_ = 0;
  switch (press.character) {
    case ' ':
      paused_ = !paused_;
      break;
    case '.':
    case 's':
      paused_ = single_ = true;
      break;
    case '+':
    case '=':
      pace_ = pace_ <= 0.0 || pace_ * 2.0 > kFastest ? 0.0 : pace_ * 2.0;
      break;
    case '-':
    case '_':
      pace_ = pace_ <= 0.0 ? kFastest : std::max(pace_ / 2.0, kSlowest);
      break;
    case 'e':
      to_the_end_ = true;
      break;
    case 'q':
      throw Stopped{};
    default:
      break;
  }
}

void Session::show_step(const std::string& title, const std::vector<terminal::CellLabel>& labels,
                        const CellStep& step, std::uint64_t moves) {
  terminal::Page page(
      console_.size(), console_.look(),
      {{"space pauses, s or arrow right steps, + faster, - slower, e to the end, q breaks off",
        terminal::Ink::faint}});
  page.line(fmt::format("{}   {}", title, pace_text()), terminal::Ink::strong);
  const std::string where = fmt::format("{:.10g} s, {} moves, at {},{},{}", step.time_s, moves,
                                        step.pose.cell.x, step.pose.cell.y, map::letter(step.pose.facing));
  page.line(page.columns() < 72 ? fmt::format("{}: {}", where, step.move)
                                : fmt::format("{}: senses {}, then {}", where, step.sense, step.move));
  draw_map(page, page.rows_left(), labels);
  console_.show(page.finish());
}

std::optional<WalkReport> Session::watch(const std::string& title,
                                         const std::vector<terminal::CellLabel>& labels,
                                         const std::function<WalkReport(const OnStep&)>& walk) {
  paused_ = single_ = false;
  to_the_end_ = !console_.is_live();
  due_us_ = drawn_us_ = 0;
  std::uint64_t moves = 0;
  const auto on_step = [&](const CellStep& step) {
    pose_ = step.pose;
    picture_->add_trail(step.pose.cell);
    if (to_the_end_) {
      if (moves++ % kLookEvery_moves == 0 && console_.is_live()) obey(console_.wait(0));
      return;
    }
    if (single_) single_ = false;  // the requested step is complete
    bool changed = true;
    while (!to_the_end_) {
      const std::int64_t now = console_.now_us();
      if (due_us_ == 0) due_us_ = now + (pace_ > 0.0 ? static_cast<std::int64_t>(1e6 / pace_) : 0);
      const bool is_due = !paused_ && now >= due_us_;
      if (changed && (paused_ || pace_ < 30.0 || now - drawn_us_ >= kFrame_us)) {
        show_step(title, labels, step, moves);
        drawn_us_ = now;
        changed = false;
      }
      if (is_due) {
        const terminal::Press press = now - drawn_us_ < 1000 ? console_.wait(0) : terminal::Press{};
        if (press.kind != Kind::nothing) {
          obey(press);
          changed = true;
          continue;
        }
        due_us_ += pace_ > 0.0 ? static_cast<std::int64_t>(1e6 / pace_) : 0;
        if (due_us_ < now - 100'000) due_us_ = now;  // does not catch up on a delay
        break;
      }
      const std::int64_t left_us = paused_ ? 200'000 : due_us_ - now;
      const terminal::Press press = console_.wait(static_cast<int>(left_us / 1000 + 1));
      if (press.kind != Kind::nothing) obey(press);
      changed = true;  // a key or a resize may have changed the display
      if (single_) break;
    }
    ++moves;
  };
  try {
    const WalkReport report = walk(on_step);
    pose_ = report.end;
    picture_->add_trail(pose_.cell);
    return report;
  } catch (const Stopped&) {
    return std::nullopt;
  }
}

}  // namespace robosim::play
