#include "sim/view/terminal/floor_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/map/floor_image.h"

namespace robosim::terminal {
namespace {

// Minimum width of a line, in dots. A narrower line would have holes.
constexpr double kLeastLine_dots = 1.2;
constexpr double kMostDotsPerCell = 16.0;
// An offset in dots. A point between two dots, such as the centre of a cell, belongs to the right and lower
// dot.
constexpr Vec2 kAside{-0.1, 0.1};
// Returns an upper limit of the distance from a stripe to a painted dot, in metres.
double reach(const map::Map& map) {
  double most = std::max(map.line_m, map.cell_m);
  for (const map::Paint& paint : map.course.paints) most = std::max(most, paint.width);
  return most;
}

map::CellAt cell_of(const map::Map& map, Vec2 p) {
  return {static_cast<int>(std::floor(p.x / map.cell_m)),
          map.height - 1 - static_cast<int>(std::floor(p.y / map.cell_m))};
}

}  // namespace

Area area_of(const map::Map& map) { return {{0.0, 0.0}, {map.width * map.cell_m, map.height * map.cell_m}}; }

Window fit(const map::Map& map, Area area, int columns, int rows) {
  const Vec2 size = area.most - area.least;
  columns = std::max(columns, 1);
  rows = std::max(rows, 1);
  Window window;
  window.dot_m = std::max(size.x / (2.0 * columns), size.y / (4.0 * rows));
  // The small constant protects an exact fit from rounding.
  const double dots_per_cell = std::min(map.cell_m / window.dot_m + 1e-9, kMostDotsPerCell);
  if (dots_per_cell >= 1.0) window.dot_m = map.cell_m / std::floor(dots_per_cell);
  window.columns = std::clamp(static_cast<int>(std::ceil(size.x / window.dot_m / 2.0 - 1e-6)), 1, columns);
  window.rows = std::clamp(static_cast<int>(std::ceil(size.y / window.dot_m / 4.0 - 1e-6)), 1, rows);
  window.top_left = {area.least.x, area.most.y};
  return window;
}

char32_t arrow(double yaw_rad) {
  constexpr char32_t kEightArrows[] = U"→↗↑↖←↙↓↘";
  const long step = std::lround(yaw_rad / (std::numbers::pi / 4.0));
  return kEightArrows[static_cast<std::size_t>((step % 8 + 8) % 8)];
}

FloorPicture::FloorPicture(const map::Map& map)
    : map_(map), paints_(map::paints_of(map)), stripes_(map, reach(map)) {}

void FloorPicture::look_at(const Window& window) {
  window_ = window;
  const auto characters = static_cast<std::size_t>(window.columns) * static_cast<std::size_t>(window.rows);
  for (Layer* layer : {&wall_, &relief_, &line_, &thin_line_, &trail_, &robot_}) layer->assign(characters, 0);
  const double line_reach = std::min(kLeastLine_dots * window.dot_m / 2.0, reach(map_));
  for (int y = 0; y < window.rows * 4; ++y) {
    for (int x = 0; x < window.columns * 2; ++x) {
      const Vec2 p = window.top_left + Vec2{(x + 0.5) * window.dot_m, -(y + 0.5) * window.dot_m};
      if (is_painted(p, line_reach, true)) set(line_, {x, y});
      if (is_painted(p + kAside * window.dot_m, window.dot_m / 2.0, false)) set(thin_line_, {x, y});
    }
  }
  for (int row = 0; row < window.rows; ++row) {
    for (int column = 0; column < window.columns; ++column) {
      const Vec2 middle =
          window.top_left + Vec2{(column * 2 + 1) * window.dot_m, -(row * 4 + 2) * window.dot_m};
      const map::CellAt cell = cell_of(map_, middle);
      const auto i = static_cast<std::size_t>(row * window.columns + column);
      wall_[i] = map_.contains(cell) && map_.at(cell) == map::Cell::wall;
      // Only every second character gets a symbol, so that the line stays dominant.
      if ((row + column) % 2 == 0) relief_[i] = static_cast<std::uint8_t>(relief_at(middle));
    }
  }
}

char FloorPicture::relief_at(Vec2 p) const {
  constexpr double kLevel_m = 1e-5;  // smallest visible height difference between dots
  const map::Hill* highest = nullptr;
  for (const map::Hill& hill : map_.course.hills)
    if (hill.contains(p) && (!highest || hill.height_at(p) >= highest->height_at(p))) highest = &hill;
  if (!highest) return has_surface(p) ? '~' : '\0';
  if (highest->pivot > 0.0) return '=';
  const auto climb = [&](Vec2 way) {
    return highest->height_at(p + way * window_.dot_m) - highest->height_at(p - way * window_.dot_m);
  };
  const double east = climb({1.0, 0.0}), north = climb({0.0, 1.0});
  if (std::max(std::fabs(east), std::fabs(north)) < kLevel_m) return ':';
  if (std::fabs(east) >= std::fabs(north)) return east > 0.0 ? '>' : '<';
  return north > 0.0 ? '^' : 'v';
}

bool FloorPicture::has_surface(Vec2 p) const {
  const map::CellAt cell = cell_of(map_, p);
  if (map_.contains(cell) && map_.surface_at(map_.index_of(cell)) != 0) return true;
  return std::any_of(map_.course.surfaces.begin(), map_.course.surfaces.end(),
                     [&](const map::Surface& surface) { return surface.contains(p); });
}

bool FloorPicture::is_painted(Vec2 p, double reach_m, bool whole) const {
  const map::CellAt cell = cell_of(map_, p);
  if (!map_.contains(cell)) return false;
  // An area counts as painted if its colour differs from the floor's.
  for (const map::Area& area : map_.course.areas)
    if (area.contains(p) && area.colour.hue != (map_.light_line ? map::Hue::black : map::Hue::white))
      return true;
  if (map_.image) {
    const double side = 2.0 * (whole ? std::max(reach_m, map_.line_m / 2.0) : reach_m);
    return (map_.image->darkness(p, side) >= 0.5) != map_.light_line;
  }
  if (map_.raster) return map::is_line(map_.at(cell)) && map_.at(cell) != map::Cell::gap;
  const auto near = stripes_.near(cell);
  return std::any_of(near.begin(), near.end(), [&](std::uint32_t i) {
    const map::Stripe& stripe = stripes_.all()[i];
    const double most = whole ? std::max(reach_m, paints_[stripe.paint].width / 2.0) : reach_m;
    return stripe.painted && map::distance(stripe, p) <= most;
  });
}

FloorPicture::Dot FloorPicture::dot_of(Vec2 p) const {
  const Vec2 d = p - kAside * window_.dot_m - window_.top_left;
  // Distant points would overflow an int. They only need to be outside.
  const auto index = [&](double metres) {
    return static_cast<int>(std::floor(std::clamp(metres / window_.dot_m, -1e6, 1e6)));
  };
  return {index(d.x), index(-d.y)};
}

void FloorPicture::set(Layer& layer, Dot dot) const {
  if (dot.x < 0 || dot.y < 0 || dot.x >= window_.columns * 2 || dot.y >= window_.rows * 4) return;
  constexpr std::uint8_t kBits[4][2] = {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};
  layer[static_cast<std::size_t>(dot.y / 4 * window_.columns + dot.x / 2)] |= kBits[dot.y % 4][dot.x % 2];
}

void FloorPicture::draw_line(Layer& layer, Vec2 from, Vec2 to) const {
  const double steps = std::min(std::ceil(length(to - from) / (0.7 * window_.dot_m)), 10'000.0);
  for (double i = 0.0; i <= steps; i += 1.0) {
    set(layer, dot_of(from + (to - from) * (steps > 0.0 ? i / steps : 0.0)));
  }
}

void FloorPicture::add_trail(Vec2 from, Vec2 to) { draw_line(trail_, from, to); }

void FloorPicture::set_robot(const std::vector<Vec2>& outline, Vec2 middle, Vec2 front) {
  std::fill(robot_.begin(), robot_.end(), std::uint8_t{0});
  for (std::size_t i = 0; i < outline.size(); ++i) {
    draw_line(robot_, outline[i], outline[(i + 1) % outline.size()]);
  }
  draw_line(robot_, middle, front);
}

void FloorPicture::draw(Frame& frame, int column, int row, const std::vector<Mark>& marks, Look look) const {
  for (int y = 0; y < window_.rows; ++y) {
    for (int x = 0; x < window_.columns; ++x) {
      const auto i = static_cast<std::size_t>(y * window_.columns + x);
      Glyph glyph{U' ', Ink::plain};
      if (robot_[i]) {
        glyph = {0x2800 + char32_t{robot_[i]}, Ink::robot};
      } else if (trail_[i]) {
        glyph = {0x2800 + char32_t{trail_[i]}, Ink::trail};
      } else if (look.colour ? line_[i] : thin_line_[i]) {
        // Without colours, braille dots of line and trail would look the same.
        glyph = {look.colour ? 0x2800 + char32_t{line_[i]} : U'·', Ink::line};
      } else if (wall_[i]) {
        glyph = {U'░', Ink::wall};
      } else if (relief_[i]) {
        glyph = {relief_[i], Ink::faint};
      }
      frame.set(column + x, row + y, glyph);
    }
  }
  for (const Mark& mark : marks) {
    const Dot dot = dot_of(mark.at);
    if (dot.x < 0 || dot.y < 0 || dot.x >= window_.columns * 2 || dot.y >= window_.rows * 4) continue;
    frame.set(column + dot.x / 2, row + dot.y / 4, mark.glyph);
  }
}

}  // namespace robosim::terminal
