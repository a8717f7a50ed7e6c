// Represents the paint on a floor as lines, bars and cells that can be queried by position. Lengths are in
// mm, x east and y north from the floor's lower left corner.
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "sim/map/map.h"
#include "sim/map/stripes.h"

namespace robosim::print {

struct Box {
  double left, low, right, high;
  Box wider(double by) const { return {left - by, low - by, right + by, high + by}; }
  bool meets(const Box& o) const { return left < o.right && o.left < right && low < o.high && o.low < high; }
};

/// A straight line, or a counter-clockwise arc about `centre`, as in map::Stripe.
struct Line {
  Vec2 from, to, centre;
  double radius = 0.0;  ///< 0 = straight
  std::size_t paint = 0;
};

/// A bar with straight ends.
struct Bar {
  Vec2 from, to;
  double width;
  std::size_t paint = 0;
};

class Shapes {
 public:
  explicit Shapes(const map::Map& map);

  /// Returns the paints, to which lines and bars refer by index.
  const std::vector<map::Paint>& paints() const { return paints_; }
  /// Divides the lines with this paint into parts, and calls `use` for each part that may reach into the box.
  /// A part is at most `longest` long, and turns by at most 22.5 degrees. Each part has round ends, so that
  /// adjacent parts join without gaps.
  void lines_near(std::size_t paint, const Box& box, double longest,
                  const std::function<void(const Line&)>& use) const;
  const std::vector<Bar>& bars() const { return bars_; }
  /// Call `use` for each run of adjacent cells within the box: painted cells of a raster floor, or walls.
  void painted_cells_near(const Box& box, const std::function<void(const Box&)>& use) const;
  void walls_near(const Box& box, const std::function<void(const Box&)>& use) const;
  std::vector<Vec2> obstacles_near(const Box& box) const;
  /// Returns whether any paint is within the box.
  bool paints(const Box& box) const;

 private:
  template <class Holds>
  void runs_near(const Box& box, Holds holds, const std::function<void(const Box&)>& use) const;
  bool any_line(const Line& line, const Box& box) const;

  const map::Map* map_;
  double half_width(const Line& line) const;
  std::vector<map::Paint> paints_;
  double cell_;
  std::vector<Line> lines_;
  std::vector<Bar> bars_;
};

}  // namespace robosim::print
