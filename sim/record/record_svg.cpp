#include "sim/record/record_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "sim/base/file.h"
#include "sim/base/markup.h"
#include "sim/base/profile.h"
#include "sim/map/floor_image.h"
#include "sim/map/map.h"
#include "sim/record/floor_shapes.h"
#include "sim/record/trail_path.h"

namespace robosim::record {
namespace {

constexpr double kTolerance_mm = 0.5;
constexpr double kWidth_px = 960.0;
constexpr const char* kLight = "#f6f4ee";
constexpr const char* kDark = "#1f1f1f";
constexpr std::uintmax_t kLargestDrawnMap_bytes = 1'000'000;

/// Returns 1, 2 or 5 times a power of ten: the largest such length up to a fifth of the width.
double scale_bar_mm(double width_mm) {
  double bar = std::pow(10.0, std::floor(std::log10(std::max(width_mm / 5.0, 1.0))));
  for (const double factor : {5.0, 2.0})
    if (bar * factor <= width_mm / 5.0) return bar * factor;
  return bar;
}

class Drawing {
 public:
  explicit Drawing(const FloorShapes& floor) : floor_(floor) {
    em_ = std::max(floor.width_mm, 0.8 * floor.height_mm) / 58.0;
  }

  void open(const std::string& title) {
    const double height = floor_.height_mm + 5.6 * em_;
    put(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {:.0f} {:.0f}" width="{:.0f}" height="{:.0f}" role="img" font-family="system-ui, sans-serif" font-size="{:.1f}">)",
        floor_.width_mm, height, kWidth_px, kWidth_px * height / std::max(floor_.width_mm, 1.0), em_);
    put("<title>{}</title>", markup_text(title));
    put(R"(<rect width="100%" height="100%" fill="#fff"/>)");
  }

  void floor() {
    put(R"(<rect width="{:.1f}" height="{:.1f}" fill="{}"/>)", floor_.width_mm, floor_.height_mm,
        floor_.light_line ? kDark : kLight);
    if (const auto& picture = floor_.picture)
      put(R"(<image x="0" y="{:.1f}" width="{:.1f}" height="{:.1f}" preserveAspectRatio="none" href="data:image/png;base64,{}"/>)",
          floor_.height_mm - picture->height_mm, picture->width_mm, picture->height_mm, picture->png);
    rectangles(floor_.walls, "#b9b4a8");
    rectangles(floor_.dark, kDark);
    areas(false);
    const char* const colour = floor_.light_line ? kLight : kDark;
    for (auto first = floor_.stripes.begin(); first != floor_.stripes.end();) {
      const auto last = std::find_if_not(first, floor_.stripes.end(),
                                         [&](const FloorShapes::Stripe& s) { return s.is_like(*first); });
      stripes(first, last, colour);
      first = last;
    }
    for (const auto& [x, y, to_x, to_y, width] : floor_.marks)
      put(R"(<path d="M{}L{}" stroke="{}" stroke-width="{:.1f}"/>)", point(x, y), point(to_x, to_y), colour,
          width);
    areas(true);
    for (const auto& [x, y] : floor_.obstacles) cross(x, y, 0.3 * floor_.cell_mm, "#8a4b08");
  }

  // Draws stripes with the same pen. Worn paint is translucent.
  template <class It>
  void stripes(It first, It last, const char* usual) {
    std::string path;
    auto to = std::back_inserter(path);
    const FloorShapes::Stripe& pen = *first;
    for (; first != last; ++first) {
      const FloorShapes::Stripe& s = *first;
      if (!s.painted) continue;
      const auto& [x, y, to_x, to_y] = s.line;
      fmt::format_to(to, "M{} ", point(x, y));
      // A line of length 0 still has round ends.
      if (s.arc[2] > 0.0)
        fmt::format_to(to, "A{:.1f} {:.1f} 0 0 0 {}", s.arc[2], s.arc[2], point(to_x, to_y));
      else
        fmt::format_to(to, "L{}", point(to_x, to_y));
    }
    put(R"(<path d="{}" fill="none" stroke="{}" stroke-width="{:.1f}"{} stroke-linecap="round"/>)", path,
        pen.colour.empty() ? usual : pen.colour.c_str(), pen.width_mm > 0.0 ? pen.width_mm : floor_.line_mm,
        pen.worn > 0.0 ? fmt::format(R"( opacity="{:.2f}")", 1.0 - pen.worn) : "");
  }

  void areas(bool over_lines) {
    const auto sticks_out = [&](const FloorShapes::Area& area) {
      const auto off = [&](double x, double y) {
        return x < 0.0 || y < 0.0 || x > floor_.width_mm || y > floor_.height_mm;
      };
      const auto [x, y, r] = area.disc;
      return area.over_lines == over_lines &&
             (r > 0.0 ? off(x - r, y - r) || off(x + r, y + r)
                      : std::any_of(area.corners.begin(), area.corners.end(),
                                    [&](const auto& corner) { return off(corner[0], corner[1]); }));
    };
    // A nested picture clips areas that extend beyond the floor.
    const bool cut = std::any_of(floor_.areas.begin(), floor_.areas.end(), sticks_out);
    if (cut) put(R"(<svg width="{:.1f}" height="{:.1f}">)", floor_.width_mm, floor_.height_mm);
    for (const FloorShapes::Area& area : floor_.areas) {
      if (area.over_lines != over_lines) continue;
      if (area.disc[2] > 0.0) {
        put(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}" fill="{}"/>)", area.disc[0], flip(area.disc[1]),
            area.disc[2], area.colour);
        continue;
      }
      std::string path;
      for (const auto& [x, y] : area.corners) path += (path.empty() ? "M" : "L") + point(x, y);
      put(R"(<path d="{}Z" fill="{}"/>)", path, area.colour);
    }
    if (cut) put("</svg>");
  }

  void stations(const std::vector<wire::Started::Station>& stations) {
    const double radius = 0.75 * em_;
    for (const wire::Started::Station& s : stations) {
      const double x = (s.x + 0.5) * floor_.cell_mm, y = floor_.height_mm - (s.y + 0.5) * floor_.cell_mm;
      put(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}" fill="#fff" stroke="#1f1f1f" stroke-width="{:.1f}"/>)",
          x, flip(y), radius, 0.1 * em_);
      put(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="middle" font-size="{:.1f}">{}</text>)", x,
          flip(y) + 0.3 * em_, 0.9 * em_, markup_text(s.name));
    }
  }

  void trail(const std::vector<SvgRecorder::Point>& trail, double fastest) {
    const double width = std::min(0.4 * floor_.line_mm, 0.5 * em_);
    const auto all = stretches(trail, fastest);
    std::string halo;
    std::vector<std::string> coloured(kSpeedColours);
    for (const Stretch& stretch : all) {
      std::string path;
      for (const std::size_t i : corners(trail, stretch.first, stretch.last, kTolerance_mm))
        path += (path.empty() ? "M" : "L") + point(trail[i].x_mm, trail[i].y_mm);
      halo += path;
      coloured[static_cast<std::size_t>(stretch.colour)] += path;
    }
    put(R"(<g fill="none" stroke-linecap="round" stroke-linejoin="round" stroke-width="{:.1f}">)", width);
    put(R"(<path d="{}" stroke="#fff" stroke-width="{:.1f}"/>)", halo, 1.5 * width);
    for (int i = 0; i < kSpeedColours; ++i) {
      const std::string& path = coloured[static_cast<std::size_t>(i)];
      if (!path.empty()) put(R"(<path d="{}" stroke="{}"/>)", path, speed_colour(i));
    }
    put("</g>");
  }

  void cross(double x, double y, double half, const char* colour) {
    put(R"(<path d="M{}L{}M{}L{}" stroke="{}" stroke-width="{:.1f}" stroke-linecap="round"/>)",
        point(x - half, y - half), point(x + half, y + half), point(x - half, y + half),
        point(x + half, y - half), colour, 0.25 * em_);
  }

  void robot(const wire::RobotInfo& info, const result::Pose& pose) {
    const double x = pose.x_mm, y = pose.y_mm, yaw = pose.yaw_rad;
    const double c = std::cos(yaw), s = std::sin(yaw);
    const auto world = [&](double forward, double left) {
      return point(x + c * forward - s * left, y + s * forward + c * left);
    };
    std::string path;
    for (const auto& [forward, left] : info.outline_mm)
      path += (path.empty() ? "M" : "L") + world(forward, left);
    put(R"(<path d="{}Z" fill="#0072b2" fill-opacity="0.25" stroke="#0072b2" stroke-width="{:.1f}" stroke-linejoin="round"/>)",
        path, 0.18 * em_);
    const double track = info.track_mm, wheel = info.wheel_mm;
    for (const double side : {0.5, -0.5}) {
      if (track <= 0.0 || wheel <= 0.0) break;
      put(R"(<path d="M{}L{}" stroke="#1f1f1f" stroke-width="{:.1f}"/>)", world(-wheel / 2, side * track),
          world(wheel / 2, side * track), 0.12 * track);
    }
    std::string dots;
    for (const auto& sensor : info.sensors) dots += fmt::format("M{0}L{0}", world(sensor.x_mm, sensor.y_mm));
    if (!dots.empty())
      put(R"(<path d="{}" stroke="#d55e00" stroke-width="{:.1f}" stroke-linecap="round"/>)", dots,
          0.45 * em_);
  }

  /// Writes a name next to a robot.
  void name(const std::string& text, const result::Pose& pose) {
    put(R"(<text x="{:.1f}" y="{:.1f}" font-weight="600" fill="#0072b2" stroke="#fff" stroke-width="{:.1f}" paint-order="stroke">{}</text>)",
        pose.x_mm + 1.6 * em_, flip(pose.y_mm) - 1.2 * em_, 0.2 * em_, markup_text(text));
  }

  void legend(double fastest_mm_s, const std::string& first, const std::string& second) {
    const double top = floor_.height_mm + 1.1 * em_, right = floor_.width_mm - em_;
    put(R"(<text x="{:.1f}" y="{:.1f}" font-weight="600">{}</text>)", em_, top + 1.0 * em_,
        markup_text(first));
    put(R"(<text x="{:.1f}" y="{:.1f}" fill="#444">{}</text>)", em_, top + 2.7 * em_, markup_text(second));
    const double step = 1.1 * em_, left = right - kSpeedColours * step;
    for (int i = 0; i < kSpeedColours; ++i)
      put(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="{}"/>)", left + i * step,
          top + 0.2 * em_, step + 0.5, 0.8 * em_, speed_colour(i));
    put(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="end">0</text>)", left - 0.4 * em_, top + em_);
    put(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="end">{:.2f} m/s</text>)", right, top + 2.1 * em_,
        fastest_mm_s / 1000.0);
    const double bar = scale_bar_mm(floor_.width_mm);
    put(R"(<path d="M{:.1f} {:.1f}h{:.1f}" stroke="#1f1f1f" stroke-width="{:.1f}"/>)", right - bar,
        top + 3.0 * em_, bar, 0.15 * em_);
    put(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="end">{}</text>)", right, top + 4.0 * em_,
        bar >= 1000.0 ? fmt::format("{:.0f} m", bar / 1000.0) : fmt::format("{:.0f} mm", bar));
  }

  std::string close() {
    put("</svg>");
    return text();
  }

  std::string text() { return std::move(text_); }

 private:
  template <class... Values>
  void put(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
    text_ += '\n';
  }
  double flip(double y) const { return floor_.height_mm - y; }
  std::string point(double x, double y) const { return fmt::format("{:.1f} {:.1f}", x, flip(y)); }
  void rectangles(const std::vector<FloorShapes::Rectangle>& all, const char* colour) {
    std::string path;
    for (const auto& [x, y, width, height] : all)
      path += fmt::format("M{}h{:.1f}v{:.1f}h{:.1f}z", point(x, y), width, -height, -width);
    if (!path.empty()) put(R"(<path d="{}" fill="{}"/>)", path, colour);
  }

  const FloorShapes& floor_;
  double em_ = 0.0;
  std::string text_;
};

/// Returns a map's shapes. A map that is too large to draw has only a size.
FloorShapes shapes_of(const wire::RunRequest& request, const wire::Started& started) {
  std::error_code error;
  const auto bytes = std::filesystem::file_size(request.map, error);
  if (!error && bytes <= kLargestDrawnMap_bytes) {
    const map::Map map = map::read_map(request.map, {request.seed, profile_of(request.profile)});
    if (!map.image || map.image->png().size() <= kLargestPicture_bytes) return floor_shapes(map, started);
  }
  FloorShapes shapes;
  shapes.cell_mm = started.cell_mm;
  shapes.width_mm = started.width * started.cell_mm;
  shapes.height_mm = started.height * started.cell_mm;
  shapes.line_mm = 0.2 * started.cell_mm;
  return shapes;
}

}  // namespace

std::string floor_elements(const FloorShapes& floor) {
  Drawing drawing(floor);
  drawing.floor();
  return drawing.text();
}

void SvgRecorder::ask(wire::RunRequest& request) const {
  Recorder::ask(request);
  request.notes = true;
}

void SvgRecorder::begin(const RecordedRun& run) {
  run_ = run;
  drives_.resize(std::max<std::size_t>(run.robots.size(), 1));
}

void SvgRecorder::add(const wire::Event& event) {
  if (const auto* sample = std::get_if<wire::Sample>(&event)) {
    Drive& drive = drives_.at(static_cast<std::size_t>(sample->agent));
    drive.trail.push_back({sample->x_mm, sample->y_mm, sample->speed_mm_s, drive.hand.has_moved()});
  } else if (const auto* note = std::get_if<wire::Note>(&event)) {
    Drive& drive = drives_.at(static_cast<std::size_t>(note->agent));
    drive.hand.add(*note);
    if (note->is<result::CollisionBegan>() && !drive.trail.empty()) collisions_.push_back(drive.trail.back());
  } else if (const auto* started = std::get_if<wire::Started>(&event)) {
    if (started->agent == 0) started_ = *started;
  }
}

void SvgRecorder::finish(const result::RunResult& result) {
  const FloorShapes floor = shapes_of(run_.request, started_);
  double fastest = 1.0;
  for (const Drive& drive : drives_)
    for (const Point& p : drive.trail) fastest = std::max(fastest, std::fabs(p.speed_mm_s));
  Drawing drawing(floor);
  const Words words = run_.robots.empty() ? words_of_one(result) : words_of_several(result);
  drawing.open(words.title);
  drawing.floor();
  for (const Drive& drive : drives_) drawing.trail(drive.trail, fastest);
  drawing.stations(started_.stations);
  for (const Point& p : collisions_) drawing.cross(p.x_mm, p.y_mm, 20.0, "#d55e00");
  if (run_.robots.empty()) drawing.robot(run_.robot_info, result.end);
  for (std::size_t i = 0; i < run_.robots.size(); ++i) {
    const result::Pose& end = i == 0 ? result.end : result.others.at(i - 1).end;
    drawing.robot(run_.robots[i].info, end);
    drawing.name(run_.robots[i].name, end);
  }
  drawing.legend(fastest, words.first, words.second);
  write_file(path_, content(drawing.close()));
}

SvgRecorder::Words SvgRecorder::words_of_one(const result::RunResult& result) const {
  const std::string what = fmt::format("{} · {} on {} · goal {} · seed {} · {} · {}", run_.sketch, run_.robot,
                                       run_.map, result.goal, result.seed, result.profile, run_.target);
  return {what + " · " + result.verdict,
          fmt::format("{} on {}: {} after {:.2f} s", run_.sketch, run_.map, result.verdict, result.time_s),
          fmt::format("{:.2f} m driven{}; robot {}, seed {}", result.metrics.distance_m,
                      run_.robot_info.sensors.empty()
                          ? ""
                          : fmt::format(", its sensors {:.1f} mm off the line at most",
                                        result.metrics.cross_track_max_mm),
                      run_.robot, result.seed)};
}

SvgRecorder::Words SvgRecorder::words_of_several(const result::RunResult& result) const {
  int reached = result.status == 0, collisions = result.metrics.collisions;
  double last_s = result.time_s;
  for (const result::RunResult& other : result.others) {
    reached += other.status == 0;
    collisions += other.metrics.collisions;
    last_s = std::max(last_s, other.time_s);
  }
  const std::string what = fmt::format("{} robots on {}", run_.robots.size(), run_.map);
  return {fmt::format("{} · seed {} · {}", what, result.seed, result.profile),
          fmt::format("{}: {} of {} reached their goals, after {:.2f} s", what, reached, run_.robots.size(),
                      last_s),
          fmt::format("{} collision{}; seed {}", collisions, collisions == 1 ? "" : "s", result.seed)};
}

}  // namespace robosim::record
