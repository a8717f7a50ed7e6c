// A picture that is painted on the floor: `floor = "floor.png"` of a map (docs/reference/maps.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/base/error.h"
#include "sim/base/vec.h"

namespace robosim::grid {

/// The picture's lower left corner is the floor's. Beyond the picture the floor is white.
///
/// A pixel's darkness is 1 - value, in steps of 1/255, with a value between 0 (black) and 1 (white). The
/// value of grey is the file's; that of a colour is 0.2126 red + 0.7152 green + 0.0722 blue (ITU-R BT.709).
/// Transparent pixels count as above white.
class FloorImage {
 public:
  /// Limits of a picture's pixels, which take 4 bytes each, and of a file's bytes.
  static constexpr std::size_t kMostPixels = 50'000'000;
  static constexpr std::size_t kMostFile_bytes = std::size_t{32} << 20;

  /// Decodes a PNG of any kind except interlaced ones. `file` is for messages, `pixel_m` the side of a pixel,
  /// m. Throws InputError if it is not a PNG, damaged, or too large.
  FloorImage(std::string png, const std::string& file, double pixel_m);

  /// Returns the file's name, without folders.
  const std::string& name() const { return name_; }
  int width() const { return width_; }    ///< pixels
  int height() const { return height_; }  ///< pixels
  double pixel_m() const { return pixel_m_; }
  const std::string& png() const { return png_; }
  double wide_m() const { return width_ * pixel_m_; }
  double high_m() const { return height_ * pixel_m_; }

  /// Returns the mean darkness of a square of side `side` m about p, 0..1; exact, and at the same cost for
  /// any side. At most 10 million pixels.
  double darkness(Vec2 p, double side) const {
    return darkness_in({p.x - 0.5 * side, p.y - 0.5 * side}, {p.x + 0.5 * side, p.y + 0.5 * side});
  }
  /// Returns that of a rectangle, from its lower left to its upper right corner.
  double darkness_in(Vec2 low, Vec2 high) const;
  /// Returns the darkness of a pixel, counted from the upper left: 0 light .. 255 dark.
  std::uint8_t at(int column, int row) const {
    return static_cast<std::uint8_t>(sum(column + 1, row + 1) - sum(column, row + 1) - sum(column + 1, row) +
                                     sum(column, row));
  }

 private:
  // Returns the sum of all pixels above and to the left, modulo 2^32: differences of sums are right again.
  std::uint32_t sum(int column, int row) const {
    return sums_[static_cast<std::size_t>(row) * (static_cast<std::size_t>(width_) + 1) +
                 static_cast<std::size_t>(column)];
  }

  std::string png_, name_;
  int width_ = 0, height_ = 0;
  double pixel_m_, per_pixel_;
  std::vector<std::uint32_t> sums_;
};

}  // namespace robosim::grid
