#include "sim/view/terminal/live_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/view/terminal/text.h"
#include "sim/wire/agent_of.h"

namespace robosim::terminal {
namespace {

constexpr int kSerialRows = 3;
constexpr int kMostReadingRows = 4;
constexpr int kMostTold = 3;
constexpr int kBar = 10;  // characters
constexpr std::size_t kSerialKept = 4096;
// A map is shown whole if a cell gets at least this many dots. Otherwise the window follows the robot at a
// larger scale.
constexpr double kLeastDotsPerCell = 3.0;
constexpr double kFollowDotsPerCell = 8.0;

int put_bar(Frame& frame, int column, int row, double share, Ink ink, Look look) {
  frame.set(column++, row, {look.utf8 ? U'▕' : U'[', Ink::faint});
  for (const char32_t c : bar(share, kBar, look.utf8)) frame.set(column++, row, {c, ink});
  frame.set(column++, row, {look.utf8 ? U'▏' : U']', Ink::faint});
  return column;
}

}  // namespace

LiveScene::LiveScene(std::string title, const map::Map& map, const wire::RobotInfo& robot,
                     std::vector<std::string> names)
    : title_(std::move(title)), names_(std::move(names)), map_(map), robot_(robot), floor_(map) {}

void LiveScene::add_other(const wire::Event& event, int agent) {
  Other& other = others_[agent];
  if (const auto* sample = std::get_if<wire::Sample>(&event)) {
    const bool first = other.trail.empty();
    other.trail.add(*sample);
    if (first) other.drawn_to = other.trail.last();
    if (!other.trail.was_carried()) floor_.add_trail(other.drawn_to, other.trail.last());
    other.drawn_to = other.trail.last();
  } else if (const auto* note = std::get_if<wire::Note>(&event)) {
    other.trail.add(*note);
    const auto number = static_cast<std::size_t>(agent);
    note_ = fmt::format("{:.2f} s  {}: {}", static_cast<double>(note->t_ns) * 1e-9,
                        number < names_.size() ? names_[number] : std::to_string(agent), note->text);
  }
}

void LiveScene::draw_trails() {
  trail_.draw(floor_);
  for (const auto& [number, other] : others_) other.trail.draw(floor_);
}

void LiveScene::add(const wire::Event& event) {
  const int agent = wire::agent_of(event);
  if (agent != 0) return add_other(event, agent);
  if (const auto* sample = std::get_if<wire::Sample>(&event)) {
    trail_.add(*sample);
    if (!sample_) drawn_to_ = trail_.last();
    if (!trail_.was_carried()) floor_.add_trail(drawn_to_, trail_.last());
    drawn_to_ = trail_.last();
    sample_ = *sample;
  } else if (const auto* serial = std::get_if<wire::SerialText>(&event)) {
    serial_ += serial->text;
    if (serial_.size() > 2 * kSerialKept) serial_.erase(0, serial_.size() - kSerialKept);
  } else if (const auto* note = std::get_if<wire::Note>(&event)) {
    trail_.add(*note);
    note_ = fmt::format("{:.2f} s  {}{}", static_cast<double>(note->t_ns) * 1e-9,
                        names_.empty() ? "" : names_.front() + ": ", note->text);
    if (const auto* told = note->is<result::PartTold>()) told_[told->part] = told->text;
    if (const auto* visit = note->is<result::StationVisited>()) visited_.push_back(visit->station);
  } else if (const auto* started = std::get_if<wire::Started>(&event)) {
    started_ = *started;
  }
}

void LiveScene::finish(const result::RunResult& result) {
  result_ = result;
  visited_ = result.metrics.stations;
}

void LiveScene::scroll(int right, int down) {
  follows_ = false;
  const Window& w = floor_.window();
  move_window(w.top_left + Vec2{right * 0.2 * w.columns * w.dot_m, -down * 0.4 * w.rows * w.dot_m});
}

void LiveScene::follow() { follows_ = true; }

void LiveScene::move_window(Vec2 top_left) {
  Window window = floor_.window();
  const Area all = area_of(map_);
  const Vec2 size{window.columns * 2 * window.dot_m, window.rows * 4 * window.dot_m};
  // Moves the window by whole characters, so that each dot of the floor keeps its place within a character.
  // Keeps the window on the map.
  const auto snap = [](double metres, double step) { return std::round(metres / step) * step; };
  window.top_left.x = std::clamp(snap(top_left.x, 2 * window.dot_m), 0.0, std::max(all.most.x - size.x, 0.0));
  window.top_left.y =
      std::clamp(snap(top_left.y, 4 * window.dot_m), std::min(size.y, all.most.y), all.most.y);
  if (window == floor_.window()) return;
  floor_.look_at(window);
  draw_trails();
}

void LiveScene::choose_window(int columns, int rows) {
  Window window = fit(map_, area_of(map_), columns, rows);
  if (map_.cell_m / window.dot_m < kLeastDotsPerCell) {
    window.dot_m = map_.cell_m / kFollowDotsPerCell;
    const Area all = area_of(map_);
    window.columns = std::min(columns, static_cast<int>(std::ceil(all.most.x / window.dot_m / 2.0)));
    window.rows = std::min(rows, static_cast<int>(std::ceil(all.most.y / window.dot_m / 4.0)));
  }
  const Window& now = floor_.window();
  if (window.columns == now.columns && window.rows == now.rows && window.dot_m == now.dot_m) return;
  const Vec2 top_left = now.columns ? now.top_left : window.top_left;
  floor_.look_at(window);
  // Moves the window off the map. move_window() then finds a change, and redraws the trail that look_at() has
  // cleared.
  Window nowhere = window;
  nowhere.top_left = {-1.0, -1.0};
  floor_.look_at(nowhere);
  move_window(top_left);
}

void LiveScene::keep_robot_in_sight() {
  if (!follows_ || !sample_) return;
  const Window& w = floor_.window();
  const Vec2 size{w.columns * 2 * w.dot_m, w.rows * 4 * w.dot_m};
  const Vec2 in = trail_.last() - w.top_left;  // y is negative below the top
  if (in.x >= 0.2 * size.x && in.x <= 0.8 * size.x && -in.y >= 0.2 * size.y && -in.y <= 0.8 * size.y) return;
  move_window(trail_.last() + Vec2{-0.5 * size.x, 0.5 * size.y});
}

Vec2 LiveScene::to_world(double forward_m, double left_m) const {
  const double c = std::cos(sample_->yaw_rad), s = std::sin(sample_->yaw_rad);
  return trail_.last() + Vec2{c * forward_m - s * left_m, s * forward_m + c * left_m};
}

std::vector<Mark> LiveScene::marks() const {
  auto marks = floor_marks(map_, started_, trail_, visited_);
  for (const auto& [number, other] : others_)
    if (!other.trail.empty())
      marks.push_back({other.trail.last(), {arrow(other.trail.yaw_rad()), Ink::robot}});
  if (sample_) marks.push_back({trail_.last(), {arrow(sample_->yaw_rad), Ink::robot}});
  return marks;
}

bool LiveScene::is_level(const std::string& reading) const {
  return std::any_of(robot_.sensors.begin(), robot_.sensors.end(),
                     [&](const auto& s) { return s.name == reading; });
}

const std::string* LiveScene::unit_of(const std::string& reading) const {
  for (const auto& gauge : robot_.gauges)
    if (gauge.name == reading) return &gauge.unit;
  return nullptr;
}

int LiveScene::draw_readings(Frame& frame, int row, Look look) const {
  if (!sample_) return row;
  const wire::Sample& s = *sample_;
  const std::size_t count = std::min(s.readings.size(), started_.readings.size());
  std::size_t longest = 5;
  for (std::size_t i = 0; i < count; ++i) {
    if (is_level(started_.readings[i])) longest = std::max(longest, started_.readings[i].size());
  }
  int column = 0;
  const auto begin_item = [&](int width) {
    if (column == 0 || column + width <= frame.columns()) return;
    column = 0;
    ++row;
  };
  const auto item = [&](const std::string& name, double share, Ink ink, const std::string& value) {
    const int name_width = static_cast<int>(longest) + 1;
    const int width = name_width + kBar + 2 + static_cast<int>(value.size());
    begin_item(width);
    frame.put(column, row, name);
    frame.put(put_bar(frame, column + name_width, row, share, ink, look), row, value);
    column += width + 2;
  };
  item("left", std::abs(s.left), s.left < 0.0 ? Ink::bad : Ink::good, fmt::format("{:+.2f}", s.left));
  item("right", std::abs(s.right), s.right < 0.0 ? Ink::bad : Ink::good, fmt::format("{:+.2f}", s.right));
  column = 0;
  const int first = ++row;
  for (std::size_t i = 0; i < count && row - first < kMostReadingRows; ++i) {
    if (is_level(started_.readings[i])) item(started_.readings[i], s.readings[i], Ink::strong, "");
  }
  // Servos and similar parts have numbers. Buttons, LEDs and similar parts are on or off.
  if (column > 0) ++row;
  column = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string& name = started_.readings[i];
    if (is_level(name)) continue;
    if (const auto* unit = unit_of(name)) {
      const std::string value = fmt::format("{:.4g} {}", s.readings[i], *unit);
      begin_item(width_of(name) + 1 + width_of(value));
      column = frame.put(frame.put(column, row, name) + 1, row, value, Ink::strong) + 2;
      continue;
    }
    const bool on = s.readings[i] >= 0.5;
    begin_item(width_of(name) + 2);
    frame.set(column, row,
              {look.utf8 ? (on ? U'●' : U'○') : (on ? U'*' : U'-'), on ? Ink::mark : Ink::faint});
    column = frame.put(column + 2, row, name) + 2;
  }
  return column > 0 ? row + 1 : row;
}

int LiveScene::draw_told(Frame& frame, int row) const {
  int left = kMostTold;
  for (const auto& [part, text] : told_) {
    if (left-- == 0) break;
    frame.put(frame.put(0, row, part) + 1, row, text, Ink::strong);
    ++row;
  }
  return row;
}

Frame LiveScene::draw(int columns, int rows, const std::string& speed, Look look) {
  Frame frame(columns, rows);
  // Draws the panel on a separate frame first, to find the panel's height.
  Frame panel(columns, 2 + 2 * kMostReadingRows + kMostTold + 1 + kSerialRows + 1);
  int panel_rows = draw_told(panel, draw_readings(panel, 0, look));
  if (result_) {
    const int column =
        panel.put(0, panel_rows, result_->verdict + ": ", result_->status == 0 ? Ink::good : Ink::bad);
    panel.put(column, panel_rows++, result_->why);
  } else {
    panel.put(0, panel_rows++, note_, Ink::mark);
  }
  int serial_row = panel_rows;
  for (const std::string& line : last_lines(serial_, kSerialRows)) {
    panel.put(panel.put(0, serial_row, look.utf8 ? "› " : "> ", Ink::faint), serial_row, line);
    ++serial_row;
  }
  panel_rows += kSerialRows;  // even if empty, so that the floor keeps its size
  const int floor_rows = std::max(rows - panel_rows - 2, 3);

  choose_window(columns, floor_rows);
  keep_robot_in_sight();
  if (sample_) {
    std::vector<Vec2> outline;
    double front_m = 0.0;
    for (const auto& [x, y] : robot_.outline_mm) {
      outline.push_back(to_world(x / 1000.0, y / 1000.0));
      front_m = std::max(front_m, x / 1000.0);
    }
    floor_.set_robot(outline, trail_.last(), to_world(front_m, 0.0));
  }
  floor_.draw(frame, 0, 1, marks(), look);

  // Changing values come first: a long title must not push them out of a narrow window.
  int column = 0;
  if (sample_) {
    column = frame.put(0, 0,
                       fmt::format("t {}  {:.2f} m/s  ", time_text(static_cast<double>(sample_->t_us) * 1e-6),
                                   sample_->speed_mm_s / 1000.0),
                       Ink::strong);
  }
  column = frame.put(column, 0, speed, Ink::mark);
  frame.put(column + 2, 0, title_);
  for (int row = 0; row < panel_rows; ++row) {
    for (int c = 0; c < columns; ++c) frame.set(c, 1 + floor_rows + row, panel.at(c, row));
  }
  if (result_) {
    frame.put(0, rows - 1, "the run is over: press any key", Ink::strong);
  } else {
    frame.put(0, rows - 1, "space pause  + - speed  arrows move  f follow  q end the run", Ink::faint);
  }
  return frame;
}

}  // namespace robosim::terminal
