#include "sim/run/scenario/places.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "sim/base/error.h"
#include "sim/base/parse_unsigned.h"
#include "sim/base/units.h"

namespace robosim::scenario {

map::CellAt parse_cell(const map::Map& map, const std::string& text) {
  const auto width = static_cast<std::uint64_t>(map.width), height = static_cast<std::uint64_t>(map.height);
  const std::size_t comma = std::min(text.find(','), text.size());
  const std::string_view row = std::string_view(text).substr(std::min(comma + 1, text.size()));
  const std::uint64_t x = parse_unsigned(text.substr(0, comma)).value_or(width);
  const std::uint64_t y = parse_unsigned(row).value_or(height);
  if (x >= width || y >= height)
    throw InputError(fmt::format("invalid cell: expected COLUMN,ROW from 0,0 to {},{}, got \"{}\"", width - 1,
                                 height - 1, text));
  return {static_cast<int>(x), static_cast<int>(y)};
}

Stretch parse_stretch(const map::Map& map, const std::string& text) {
  const std::size_t space = text.find(' ');
  const map::CellAt a = parse_cell(map, text.substr(0, space)), b = parse_cell(map, text.substr(space + 1));
  if (a.x != b.x && a.y != b.y)
    throw InputError(fmt::format("invalid cells: expected two in one row or one column, got {} and {}",
                                 text.substr(0, space), text.substr(space + 1)));
  return {map.centre(a), map.centre(b)};
}

Pose parse_place(const map::Map& map, const map::Stripes& stripes, const std::string& text) {
  const std::size_t first = std::min(text.find(','), text.size());
  const std::size_t second = std::min(text.find(',', first + 1), text.size());
  const auto x = parse_quantity(text.substr(0, first), Dimension::length);
  if (!x || second >= text.size()) {
    const map::Start where = map::parse_start(map, text);
    return stripes.pose_of(where);
  }
  const auto y = parse_quantity(text.substr(first + 1, second - first - 1), Dimension::length);
  constexpr double kHalf = 0.70710678118654752440;
  static constexpr std::array<std::pair<const char*, Vec2>, 8> kHeadings = {{{"N", {0.0, 1.0}},
                                                                             {"NE", {kHalf, kHalf}},
                                                                             {"E", {1.0, 0.0}},
                                                                             {"SE", {kHalf, -kHalf}},
                                                                             {"S", {0.0, -1.0}},
                                                                             {"SW", {-kHalf, -kHalf}},
                                                                             {"W", {-1.0, 0.0}},
                                                                             {"NW", {-kHalf, kHalf}}}};
  const std::string facing = text.substr(second + 1);
  const auto* const heading =
      std::find_if(kHeadings.begin(), kHeadings.end(), [&](const auto& one) { return facing == one.first; });
  const double wide = map.width * map.cell_m, high = map.height * map.cell_m;
  if (!y || heading == kHeadings.end() || *x < 0.0 || *y < 0.0 || *x > wide || *y > high)
    throw InputError(fmt::format(
        "invalid place: expected a line cell as X,Y,DIR, or a point as 352mm,118mm,NE (to the "
        "right and up from the lower left corner, at most {:.0f}mm,{:.0f}mm; N, NE, E, SE, S, SW, "
        "W or NW), got \"{}\"",
        1e3 * wide, 1e3 * high, text));
  return {{*x, *y}, heading->second};
}

}  // namespace robosim::scenario
