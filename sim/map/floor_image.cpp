#include "sim/map/floor_image.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/map/png_rows.h"

namespace robosim::map {
namespace {

// An interval of pixels, split into up to three runs. The share of a run is the covered part of each pixel in
// the run.
struct Runs {
  std::array<int, 4> edges;
  std::array<double, 3> shares;

  Runs(double from, double to, int most) {
    from = std::clamp(from, 0.0, static_cast<double>(most));
    to = std::clamp(to, 0.0, static_cast<double>(most));
    const int first = std::min(static_cast<int>(from), most - 1),
              last = std::min(static_cast<int>(to), most - 1);
    if (first == last) {
      edges = {first, first + 1, first + 1, first + 1};
      shares = {to - from, 0.0, 0.0};
    } else {
      edges = {first, first + 1, last, last + 1};
      shares = {first + 1 - from, 1.0, to - last};
    }
  }
};

}  // namespace

FloorImage::FloorImage(std::string png, const std::string& file, double pixel_m)
    : png_(std::move(png)),
      name_(std::filesystem::path(file).filename().string()),
      pixel_m_(pixel_m),
      per_pixel_(1.0 / pixel_m) {
  std::size_t above = 0;
  const auto begin = [&](int width, int height) {
    width_ = width;
    height_ = height;
    sums_.assign((static_cast<std::size_t>(width) + 1) * (static_cast<std::size_t>(height) + 1), 0);
  };
  read_png(png_, file, begin, [&](std::span<const unsigned char> values) {
    const std::size_t stride = static_cast<std::size_t>(width_) + 1;
    std::uint32_t row = 0;
    for (std::size_t x = 0; x < values.size(); ++x) {
      row += 255u - values[x];
      sums_[above + stride + x + 1] = sums_[above + x + 1] + row;
    }
    above += stride;
  });
}

double FloorImage::darkness_in(Vec2 low, Vec2 high) const {
  const double area = (high.x - low.x) * (high.y - low.y) * per_pixel_ * per_pixel_;
  if (!(area > 0.0)) return 0.0;
  const Runs columns(low.x * per_pixel_, high.x * per_pixel_, width_);
  const Runs rows(height_ - high.y * per_pixel_, height_ - low.y * per_pixel_, height_);
  // Each sum belongs to the crossing of a column edge and a row edge. Looks up each sum only once.
  std::array<std::uint32_t, 4> above{}, below{};
  const auto look_up = [&](std::array<std::uint32_t, 4>& sums, int row) {
    for (std::size_t c = 0; c < 4; ++c) sums[c] = sum(columns.edges[c], row);
  };
  look_up(above, rows.edges[0]);
  double dark = 0.0;
  for (std::size_t r = 0; r < 3; ++r) {
    look_up(below, rows.edges[r + 1]);
    double of_row = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
      of_row += columns.shares[c] * (below[c + 1] - below[c] - above[c + 1] + above[c]);
    dark += rows.shares[r] * of_row;
    above = below;
  }
  return std::min(dark / (255.0 * area), 1.0);
}

}  // namespace robosim::map
