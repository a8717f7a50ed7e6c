// A picture painted on the floor: `floor = "floor.png"` of a map (docs/reference/maps.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/base/error.h"
#include "sim/base/vec.h"

namespace robosim::map {

/// The lower left corners of picture and floor coincide. Beyond the picture the floor is white.
///
/// A pixel's darkness is 1 - value, in steps of 1/255, with a value between 0 (black) and 1 (white). The
/// value of a grey pixel is taken from the file. The value of a coloured pixel is 0.2126 red + 0.7152 green +
/// 0.0722 blue (ITU-R BT.709). Transparent pixels are blended over white.
class FloorImage {
 public:
  /// Upper limits for the size of a picture. Each pixel uses 4 bytes of memory.
  static constexpr std::size_t kMostPixels = 50'000'000;
  static constexpr std::size_t kMostFile_bytes = std::size_t{32} << 20;

  /// Decodes a PNG, which must not be interlaced. `file` is for messages; `pixel_m` is the side of a pixel in
  /// metres. Throws InputError if the data is damaged, too large, or not a PNG.
  FloorImage(std::string png, const std::string& file, double pixel_m);

  /// Returns the file's name, without folders.
  const std::string& name() const { return name_; }
  int width() const { return width_; }    ///< pixels
  int height() const { return height_; }  ///< pixels
  double pixel_m() const { return pixel_m_; }
  const std::string& png() const { return png_; }
  double wide_m() const { return width_ * pixel_m_; }
  double high_m() const { return height_ * pixel_m_; }

  /// Returns the exact mean darkness, 0..1, of a square of side `side` m around `p`. The cost does not depend
  /// on the side. The square must not exceed 10 million pixels.
  double darkness(Vec2 p, double side) const {
    return darkness_in({p.x - 0.5 * side, p.y - 0.5 * side}, {p.x + 0.5 * side, p.y + 0.5 * side});
  }
  /// Returns the mean darkness of a rectangle with the given lower left and upper right corners.
  double darkness_in(Vec2 low, Vec2 high) const;
  /// Returns the darkness of a pixel, counted from the upper left: 0 light .. 255 dark.
  std::uint8_t at(int column, int row) const {
    return static_cast<std::uint8_t>(sum(column + 1, row + 1) - sum(column, row + 1) - sum(column + 1, row) +
                                     sum(column, row));
  }

 private:
  // Returns the total darkness of all pixels above `row` and left of `column`, modulo 2^32. Differences of
  // such sums are exact.
  std::uint32_t sum(int column, int row) const {
    return sums_[static_cast<std::size_t>(row) * (static_cast<std::size_t>(width_) + 1) +
                 static_cast<std::size_t>(column)];
  }

  std::string png_, name_;
  int width_ = 0, height_ = 0;
  double pixel_m_, per_pixel_;
  std::vector<std::uint32_t> sums_;
};

}  // namespace robosim::map
