#include "sim/view/terminal/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "sim/base/terminal_text.h"
#include "sim/view/terminal/floor_picture.h"
#include "sim/view/terminal/text.h"

namespace robosim::terminal {
namespace {

constexpr int kPictureRows = 20;
constexpr std::size_t kMostTrailPoints = 8192;
constexpr std::size_t kSerialLines = 5;
// The fewest dots per map cell in a useful picture of the whole map.
constexpr double kLeastDotsPerPrintedCell = 2.0;

/// Extends an area by a point.
void include(Area& area, Vec2 p) {
  area.least = {std::min(area.least.x, p.x), std::min(area.least.y, p.y)};
  area.most = {std::max(area.most.x, p.x), std::max(area.most.y, p.y)};
}

/// Returns the area extended to whole cells, with a margin, inside the map.
Area with_margin(const Area& area, const map::Map& map, double cells) {
  const auto down = [&](double metres) { return (std::floor(metres / map.cell_m) - cells) * map.cell_m; };
  const auto up = [&](double metres) { return (std::ceil(metres / map.cell_m) + cells) * map.cell_m; };
  const Area all = area_of(map);
  return {{std::max(all.least.x, down(area.least.x)), std::max(all.least.y, down(area.least.y))},
          {std::min(all.most.x, up(area.most.x)), std::min(all.most.y, up(area.most.y))}};
}

Area around(const Trail& trail, const map::Map& map) {
  Area area{trail.last(), trail.last()};
  for (const Vec2 p : trail.points()) include(area, p);
  return with_margin(area, map, 2.0);
}

/// Returns the area of everything except plain floor.
Area content(const Trail& trail, const map::Map& map) {
  Area area{map.centre({0, map.height - 1}), map.centre({0, map.height - 1})};
  bool first = true;
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const Vec2 p = map.centre({x, y});
      if (map.at({x, y}) == map::Cell::floor) continue;
      if (first) area = {p, p};
      first = false;
      include(area, p);
    }
  }
  for (const Vec2 p : trail.points()) include(area, p);
  return with_margin(area, map, 0.0);
}

std::string picture(const Report& report, const map::Map& map, int columns, Look look) {
  const Trail& trail = report.trail;
  Window window = fit(map, content(trail, map), columns, kPictureRows);
  const bool whole = map.cell_m / window.dot_m >= kLeastDotsPerPrintedCell;
  if (!whole) {
    if (trail.empty()) return "";
    window = fit(map, around(trail, map), columns, kPictureRows);
  }
  FloorPicture floor(map);
  floor.look_at(window);
  trail.draw(floor);
  auto marks = floor_marks(map, report.started, trail, report.result.metrics.stations);
  if (!trail.empty()) marks.push_back({trail.last(), {arrow(trail.yaw_rad()), Ink::robot}});
  Frame frame(window.columns, window.rows);
  floor.draw(frame, 0, 0, marks, look);
  return to_text(frame, look) + (whole ? "" : "(the part of the map that the robot saw)\n");
}

Ink ink_of(const result::RunResult& result) { return result.status == 0 ? Ink::good : Ink::bad; }

/// Writes lines, wrapped and coloured.
class Writer {
 public:
  Writer(int columns, Look look) : columns_(columns), look_(look) {}

  void line(std::string_view text = "", Ink ink = Ink::plain) {
    if (ink != Ink::plain) written_ += select(ink, look_);
    for (const char32_t c : printable(text)) append(written_, c, look_.utf8);
    if (ink != Ink::plain) written_ += select(Ink::plain, look_);
    written_ += '\n';
  }
  /// Adds wrapped text.
  void text(std::string_view words, Ink ink) {
    for (const std::string& part : wrap(words, std::max(columns_, 20))) line(part, ink);
  }
  /// Adds "label: text". Further lines of the text have the same indentation.
  void labelled(std::string_view label, std::string_view text, Ink ink = Ink::plain) {
    std::string start = in_one_line(label);
    const int indent = width_of(start) + 1;
    if (ink != Ink::plain) start = select(ink, look_) + start + select(Ink::plain, look_);
    start += ' ';
    for (const std::string& part : wrap(text, std::max(columns_ - indent, 20))) {
      written_ += start;
      line(part);
      start.assign(static_cast<std::size_t>(indent), ' ');
    }
  }
  std::string take() { return std::move(written_); }
  std::string& raw() { return written_; }

 private:
  std::string written_;
  int columns_;
  Look look_;
};

std::string list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
  return text;
}

// Returns "never used: buzzer, LED2 · never changed: start (HIGH)"; empty if there is nothing to report.
std::string usage_text(const result::Usage& usage) {
  std::string text;
  const auto listed = [&](const char* label, const auto& things, auto told) {
    if (things.empty()) return;
    text += fmt::format("{}{}: ", text.empty() ? "" : " · ", label);
    for (std::size_t i = 0; i < things.size(); ++i) text += (i > 0 ? ", " : "") + told(things[i]);
  };
  listed("nothing is wired to", usage.unwired,
         [](const result::Usage::Loose& loose) { return fmt::format("{} ({})", loose.pin, loose.how); });
  listed("never used", usage.unused, [](const std::string& name) { return name; });
  listed("never changed", usage.steady, [](const result::Usage::Steady& steady) {
    return fmt::format("{} ({})", steady.part, steady.reads);
  });
  return text;
}

// Returns "by zero in position, Mean.ino:3 (214 times, first at 0.39 s). …"
std::string divisions_text(const std::vector<result::DivisionByZero>& divisions) {
  std::string text = "by zero";
  for (const result::DivisionByZero& division : divisions) {
    const result::SourceLine& where = division.where;
    text += fmt::format("{}{}{}:{} ({}{})", &division == &divisions.front() ? "" : ";",
                        where.function.empty() ? " at " : fmt::format(" in {}, ", where.function), where.file,
                        where.line,
                        division.times == 1 ? "at " : fmt::format("{} times, first at ", division.times),
                        time_text(division.first_s));
  }
  return text + ". A chip continues there with a meaningless number, as this run did.";
}

// Returns "CLKPR (Slow.ino:3 in setup()). …"
std::string lacks_text(const std::vector<result::Lack>& lacks) {
  std::string text;
  for (const result::Lack& lack : lacks) {
    const result::SourceLine& where = lack.where;
    const std::string place = where.file.empty() ? "" : fmt::format(" in {}:{}", where.file, where.line);
    text += fmt::format("{}{}{}", text.empty() ? "" : "; ", lack.what, place);
  }
  return text + ". The host has no such feature; run with --target avr to see the effect.";
}

std::string two_digits(double value) { return fmt::format("{:.10g}", std::round(value * 100.0) / 100.0); }

// Returns "35 points · 2 × gap 20, 3 × tile 15"; empty without a score.
std::string score_text(const result::Metrics& m) {
  std::string parts;
  for (const result::ScorePart& part : m.score_parts)
    parts += fmt::format("{}{}{} {}", parts.empty() ? "" : ", ",
                         part.count == 1 ? "" : fmt::format("{} × ", part.count), part.part,
                         two_digits(part.value));
  if (std::isnan(m.score)) return parts.empty() ? "" : "none yet · " + parts;
  return fmt::format("{} {}{}{}", two_digits(m.score), m.score_unit, parts.empty() ? "" : " · ", parts);
}

void write_figures(Writer& out, const Report& report) {
  const result::RunResult& r = report.result;
  const result::Metrics& m = r.metrics;
  const double mean = r.time_s > 0.0 ? m.distance_m / r.time_s : 0.0;
  const std::string back = m.energy_back_j > 0.0 ? fmt::format(", {:.1f} J of it back", m.energy_back_j) : "";
  out.labelled("time        ", fmt::format("{} · distance {:.2f} m · mean {:.2f} m/s · energy {:.1f} J{}",
                                           time_text(r.time_s), m.distance_m, mean, m.energy_j, back));
  if (!m.laps_s.empty()) {
    std::string laps;
    const std::size_t first = m.laps_s.size() > 8 ? m.laps_s.size() - 8 : 0;
    for (std::size_t i = first; i < m.laps_s.size(); ++i) laps += fmt::format(" {:.2f}", m.laps_s[i]);
    out.labelled("laps        ", fmt::format("{}, each{}{} s", m.laps_s.size(), first ? " …" : "", laps));
  }
  if (const std::string text = score_text(m); !text.empty()) out.labelled("score       ", text);
  if (report.sees_lines)
    out.labelled("cross-track ", fmt::format("{:.1f} mm RMS, {:.1f} mm at most · off the line {:.2f} s",
                                             m.cross_track_rms_mm, m.cross_track_max_mm, m.off_line_s));
  out.labelled("collisions  ", std::to_string(m.collisions));
  if (!report.started.stations.empty()) {
    out.labelled("stations    ", fmt::format("{} of {} visited{}{} · junctions {}", m.stations.size(),
                                             report.started.stations.size(), m.stations.empty() ? "" : ": ",
                                             list(m.stations), m.junctions));
  }
  if (r.resources) {
    const result::Resources& used = *r.resources;
    out.labelled("chip        ",
                 fmt::format("flash {} bytes · variables {} bytes · stack {} bytes at most · {} bytes of RAM "
                             "never used",
                             used.flash_bytes, used.ram_bytes, used.stack_bytes_max, used.free_bytes_min));
    for (const Room& room : report.rooms)
      out.labelled("room for    ", fmt::format("{} {}; with this stack {} would fit, at {} bytes each",
                                               room.now, room.what, room.fit, room.bytes_each));
    const std::string loop = used.loops == 0
                                 ? ""
                                 : fmt::format("loop() {:.3f} ms on average, {:.3f} ms at most · ",
                                               1e-3 * used.loop_us_mean, 1e-3 * used.loop_us_max);
    out.labelled("processor   ", fmt::format("{}interrupts {:.1f} % · awake {:.1f} %", loop,
                                             100.0 * used.interrupt_share, 100.0 * used.cpu_load));
  }
  if (!r.divisions_by_zero.empty()) out.labelled("division    ", divisions_text(r.divisions_by_zero));
  if (!r.lacks.empty()) out.labelled("lacks       ", lacks_text(r.lacks));
  if (r.watchdog_resets > 0)
    out.labelled("watchdog    ", r.watchdog_resets == 1
                                     ? "reset the chip once"
                                     : fmt::format("reset the chip {} times", r.watchdog_resets));
  for (const result::Detected& seen : r.detected) out.labelled("detected    ", result::text_of(seen));
  if (const std::string text = usage_text(r.usage); !text.empty()) out.labelled("wiring      ", text);
  if (report.wall_s) {
    out.labelled("wall time   ", fmt::format("{:.3f} s, {:.0f} times real time", *report.wall_s,
                                             r.time_s / std::max(*report.wall_s, 1e-9)));
  }
}

/// Returns whether `robosim why` can trace the verdict. If the goal was reached, it traces only runs with
/// advice: the robot was off the line for a long time.
bool has_causes(const result::RunResult& r) {
  if (r.verdict == "reached") return !r.next.empty();
  return r.verdict != "interrupted" && r.verdict != "over_budget";
}

std::string chip_hint(const Report& report) {
  const bool is_stm32 = report.chip_target == "stm32";
  const std::string chip =
      report.board.empty() ? "The board's chip" : fmt::format("The chip of the board {}", report.board);
  const std::string memory =
      report.chip_ram_bytes == 0
          ? "little memory"
          : fmt::format("{:.4g} KB of memory", static_cast<double>(report.chip_ram_bytes) / 1024.0);
  return fmt::format(
      "this ran on the target host, with neither the memory nor the timing of the chip. {} has {}{}: run the "
      "sketch there with --target {}.",
      chip, memory, is_stm32 ? "" : " and a 16-bit int", is_stm32 ? "stm32" : "avr");
}

}  // namespace

std::int64_t trail_every_ns(std::int64_t for_ns) {
  constexpr std::int64_t kEvery_ns = 50'000'000, kTick_ns = 1'000'000, kMostSamples = 20'000;
  return std::max(kEvery_ns, for_ns / kMostSamples / kTick_ns * kTick_ns);
}

void Trail::add(const wire::Sample& sample) {
  const auto place = [](double mm) { return std::round(100.0 * mm) / 100'000.0; };  // rounds as in recordings
  last_ = {place(sample.x_mm), place(sample.y_mm)};
  yaw_rad_ = sample.yaw_rad;
  carried_ = hand_.has_moved();
  gap_ |= carried_;
  if (seen_++ % every_ != 0) return;
  points_.push_back(last_);
  gaps_.push_back(std::exchange(gap_, false));
  if (points_.size() < kMostTrailPoints) return;
  for (std::size_t i = 0; i < points_.size() / 2; ++i) {
    points_[i] = points_[2 * i];
    gaps_[i] = gaps_[2 * i] || (i > 0 && gaps_[2 * i - 1]);
  }
  gap_ |= gaps_.back();
  points_.resize(points_.size() / 2);
  gaps_.resize(points_.size());
  every_ *= 2;
}

void Trail::draw(FloorPicture& floor) const {
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (!gaps_[i]) floor.add_trail(points_[i == 0 ? 0 : i - 1], points_[i]);
  if (!points_.empty() && !gap_) floor.add_trail(points_.back(), last_);
}

std::vector<Mark> floor_marks(const map::Map& map, const wire::Started& started, const Trail& trail,
                              const std::vector<std::string>& visited) {
  const Vec2 start = trail.empty() ? map.centre({started.x, started.y}) : trail.points().front();
  std::vector<Mark> marks{{start, {U'S', Ink::mark}}};
  for (const wire::Started::Station& station : started.stations) {
    const bool seen = std::find(visited.begin(), visited.end(), station.name) != visited.end();
    const std::u32string name = printable(station.name);
    marks.push_back(
        {map.centre({station.x, station.y}), {name.empty() ? U'?' : name[0], seen ? Ink::good : Ink::mark}});
  }
  return marks;
}

std::string end_screen(const Report& report, const map::Map* map, int columns, Look look) {
  const result::RunResult& r = report.result;
  Writer out(columns, look);
  if (map) {
    if (const std::string drawn = picture(report, *map, columns, look); !drawn.empty())
      out.raw() += drawn + "\n";
  }
  out.text(fmt::format("{} · {} on {} · goal {} · seed {} · {} · {}", report.sketch, report.robot, report.map,
                       r.goal, r.seed, r.profile, report.target),
           Ink::faint);
  out.labelled(r.verdict + ":", r.why, ink_of(r));
  out.line();
  write_figures(out, report);
  if (!r.events.empty()) {
    out.line();
    out.line("last events", Ink::strong);
    for (const auto& event : r.events) out.line(fmt::format("  {:>9.2f} s  {}", event.t_s, event.text));
  }
  if (r.crash && !r.crash->calls.empty()) {
    out.line();
    out.line("calls that were open, the last first", Ink::strong);
    for (const result::SourceLine& call : r.crash->calls)
      out.line(call.file.empty() ? "  " + call.function
                                 : fmt::format("  {}, {}:{}", call.function, call.file, call.line));
    std::istringstream registers(r.crash->registers);
    for (std::string line; std::getline(registers, line);) out.line("  " + line);
  }
  if (const auto lines = last_lines(r.serial, kSerialLines); !lines.empty()) {
    out.line();
    out.line("serial, last lines", Ink::strong);
    for (const std::string& text : lines) out.line("  " + text);
  }
  out.line();
  if (!r.next.empty()) out.labelled("next:", r.next, Ink::strong);
  if (report.target == "avr" && has_causes(r))
    out.labelled(
        "why:", "robosim why, with the same arguments, traces this verdict to the lines that caused it",
        Ink::faint);
  if (report.target == "host") out.labelled("chip:", chip_hint(report), Ink::faint);
  return out.take();
}

}  // namespace robosim::terminal
