#include "sim/map/print/shapes.h"

#include <algorithm>

#include "sim/map/floor_image.h"

namespace robosim::print {
namespace {

constexpr double kMillimetre = 1e3;
constexpr double kFine = 0.5;  // in mm: any_line() halves a line until its pieces are at most this long

Box around(const Line& line) {
  Box box{std::min(line.from.x, line.to.x), std::min(line.from.y, line.to.y),
          std::max(line.from.x, line.to.x), std::max(line.from.y, line.to.y)};
  if (line.radius == 0.0) return box;
  // An arc of at most a quarter turn stays within its chord's box, widened by the sagitta.
  const double chord = length(line.to - line.from);
  const double half = 0.5 * chord;
  return box.wider(line.radius - std::sqrt(std::max(line.radius * line.radius - half * half, 0.0)));
}

std::pair<Line, Line> halves(const Line& line) {
  Vec2 middle = (line.from + line.to) * 0.5;
  if (line.radius > 0.0) {
    const Vec2 out = middle - line.centre;
    middle = line.centre + out * (line.radius / length(out));
  }
  Line first = line, second = line;
  first.to = second.from = middle;
  return {first, second};
}

bool is_short(const Line& line, double longest) {
  constexpr double kBend = 0.3902;  // chord of 22.5 degrees, as a share of the radius
  const double chord = length(line.to - line.from);
  return chord <= longest && (line.radius == 0.0 || chord <= kBend * line.radius);
}

void near(const Line& line, const Box& box, double longest, const std::function<void(const Line&)>& use) {
  if (!around(line).meets(box)) return;
  if (is_short(line, longest)) return use(line);
  const auto [first, second] = halves(line);
  near(first, box, longest, use);
  near(second, box, longest, use);
}

}  // namespace

Shapes::Shapes(const map::Map& map)
    : map_(&map), paints_(map::paints_of(map)), cell_(map.cell_m * kMillimetre) {
  if (!map.raster && !map.image) {
    const map::Stripes stripes(map, 0.0);
    for (const map::Stripe& s : stripes.all())
      if (s.painted)
        lines_.push_back(
            {s.a * kMillimetre, s.b * kMillimetre, s.centre * kMillimetre, s.radius * kMillimetre, s.paint});
  }
  for (const map::Mark& mark : map.course.marks) {
    const Vec2 half = mark.middle.heading * mark.half_length;
    bars_.push_back({(mark.middle.position - half) * kMillimetre, (mark.middle.position + half) * kMillimetre,
                     2.0 * mark.half_width * kMillimetre, static_cast<std::size_t>(mark.paint)});
  }
}

double Shapes::half_width(const Line& line) const { return 0.5 * paints_[line.paint].width * kMillimetre; }

void Shapes::lines_near(std::size_t paint, const Box& box, double longest,
                        const std::function<void(const Line&)>& use) const {
  for (const Line& line : lines_)
    if (line.paint == paint) near(line, box.wider(half_width(line)), longest, use);
}

template <class Holds>
void Shapes::runs_near(const Box& box, Holds holds, const std::function<void(const Box&)>& use) const {
  const auto clamped = [](double cells, int most) {
    return static_cast<int>(std::clamp(cells, 0.0, static_cast<double>(most)));
  };
  const int first = clamped(std::floor(box.left / cell_), map_->width);
  const int last = clamped(std::ceil(box.right / cell_), map_->width);
  const int top = map_->height - clamped(std::ceil(box.high / cell_), map_->height);
  const int bottom = map_->height - clamped(std::floor(box.low / cell_), map_->height);
  for (int y = top; y < bottom; ++y)
    for (int x = first; x < last; ++x) {
      const int begin = x;
      while (x < last && holds(map_->at({x, y}))) ++x;
      const double low = (map_->height - 1 - y) * cell_;
      if (x > begin) use({begin * cell_, low, x * cell_, low + cell_});
    }
}

void Shapes::painted_cells_near(const Box& box, const std::function<void(const Box&)>& use) const {
  if (map_->raster)
    runs_near(
        box, [](map::Cell c) { return map::is_line(c) && c != map::Cell::gap; }, use);
}

void Shapes::walls_near(const Box& box, const std::function<void(const Box&)>& use) const {
  runs_near(
      box, [](map::Cell c) { return c == map::Cell::wall; }, use);
}

std::vector<Vec2> Shapes::obstacles_near(const Box& box) const {
  std::vector<Vec2> middles;
  runs_near(
      box, [](map::Cell c) { return c == map::Cell::obstacle; },
      [&](const Box& run) {
        for (double x = run.left + 0.5 * cell_; x < run.right; x += cell_)
          middles.push_back({x, 0.5 * (run.low + run.high)});
      });
  return middles;
}

bool Shapes::paints(const Box& box) const {
  bool found = false;
  if (map_->image)
    return map_->image->darkness_in(Vec2{box.left, box.low} * 1e-3, Vec2{box.right, box.high} * 1e-3) > 0.0;
  painted_cells_near(box, [&](const Box&) { found = true; });
  for (const Bar& bar : bars_) {
    if (found) break;
    near({bar.from, bar.to, {}, 0.0, 0}, box.wider(0.5 * bar.width), kFine,
         [&](const Line&) { found = true; });
  }
  for (const map::Area& area : map_->course.areas) {
    const Vec2 middle = area.middle.position * 1e3;
    found = found || Box{middle.x, middle.y, middle.x, middle.y}.wider(area.reach() * 1e3).meets(box);
  }
  for (const Line& line : lines_) {
    if (found) break;
    found = any_line(line, box);
  }
  return found;
}

bool Shapes::any_line(const Line& line, const Box& box) const {
  const Box reach = box.wider(half_width(line));
  if (!around(line).meets(reach)) return false;
  if (is_short(line, kFine)) return true;
  const auto [first, second] = halves(line);
  return any_line(first, box) || any_line(second, box);
}

}  // namespace robosim::print
