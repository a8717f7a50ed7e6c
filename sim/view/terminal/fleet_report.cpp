#include "sim/view/terminal/fleet_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/base/terminal_text.h"
#include "sim/view/terminal/floor_picture.h"
#include "sim/view/terminal/text.h"

namespace robosim::terminal {
namespace {

constexpr int kFleetPictureRows = 20;
constexpr double kLeastFleetDots = 2.0;
constexpr std::size_t kMostRobotsTold = 16;

std::string fleet_picture(const FleetReport& report, const map::Map& map, int columns, Look look) {
  const Window window = fit(map, area_of(map), columns, kFleetPictureRows);
  if (map.cell_m / window.dot_m < kLeastFleetDots) return "";
  FloorPicture floor(map);
  floor.look_at(window);
  std::vector<Mark> marks;
  for (const wire::Started::Station& station : report.started.stations) {
    const std::u32string name = printable(station.name);
    marks.push_back({map.centre({station.x, station.y}), {name.empty() ? U'?' : name[0], Ink::mark}});
  }
  for (const FleetRow& row : report.rows) {
    row.trail.draw(floor);
    if (!row.trail.empty()) marks.push_back({row.trail.last(), {arrow(row.trail.yaw_rad()), Ink::robot}});
  }
  Frame frame(window.columns, window.rows);
  floor.draw(frame, 0, 0, marks, look);
  return to_text(frame, look);
}

/// Formats columns as wide as their content. The cells may contain untrusted names.
std::string table(std::vector<std::vector<std::string>> rows) {
  for (auto& row : rows)
    for (std::string& cell : row) cell = in_one_line(cell);
  std::vector<int> widths(rows.front().size());
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += row[i];
      if (i + 1 < row.size()) line.append(static_cast<std::size_t>(widths[i] + 2 - width_of(row[i])), ' ');
    }
    text += line + "\n";
  }
  return text;
}

std::string paragraph(const std::string& label, const std::string& words, int columns, Ink ink, Look look) {
  const std::string shown = in_one_line(label);
  const int indent = width_of(shown) + 1;
  std::string text, start = select(ink, look) + shown + select(Ink::plain, look) + " ";
  for (const std::string& part : wrap(for_terminal(words), std::max(columns - indent, 20))) {
    text += start + part + "\n";
    start.assign(static_cast<std::size_t>(indent), ' ');
  }
  return text;
}

}  // namespace

std::string fleet_screen(const FleetReport& report, const map::Map* map, int columns, Look look) {
  std::string text;
  if (map) {
    if (const std::string drawn = fleet_picture(report, *map, columns, look); !drawn.empty())
      text += drawn + "\n";
  }
  const result::RunResult& first = report.rows.front().result;
  text += fmt::format("{} robots on {} · seed {} · {}\n\n", report.rows.size(), in_one_line(report.map),
                      first.seed, in_one_line(first.profile));
  std::vector<std::vector<std::string>> rows = {
      {"robot", "verdict", "time", "distance", "collisions", "goal", "what it is"}};
  std::size_t reached = 0;
  for (const FleetRow& row : report.rows) {
    const result::RunResult& r = row.result;
    reached += r.status == 0;
    rows.push_back({row.name, r.verdict, time_text(r.time_s), fmt::format("{:.2f} m", r.metrics.distance_m),
                    std::to_string(r.metrics.collisions), r.goal,
                    fmt::format("{} on {}, {}", row.sketch, row.robot, row.target)});
  }
  text += table(std::move(rows)) + "\n";
  // If not all robots fit, only failures are listed.
  std::size_t told = 0, untold = 0;
  const bool all = report.rows.size() <= kMostRobotsTold;
  for (const FleetRow& row : report.rows) {
    const bool good = row.result.status == 0;
    if (!all && good) continue;
    if (told == kMostRobotsTold) {
      ++untold;
      continue;
    }
    ++told;
    text += paragraph(row.name + ":", row.result.why, columns, good ? Ink::good : Ink::bad, look);
    if (!good && !row.result.next.empty())
      text += paragraph("  next:", row.result.next, columns, Ink::strong, look);
  }
  if (untold > 0) text += fmt::format("… and {} more that did not reach their goals\n", untold);
  text += fmt::format("{}{} of {} reached their goals\n", told > 0 ? "\n" : "", reached, report.rows.size());
  if (report.wall_s)
    text += fmt::format("wall time {:.3f} s, {:.0f} times real time\n", *report.wall_s,
                        first.time_s / std::max(*report.wall_s, 1e-9));
  return text;
}

}  // namespace robosim::terminal
