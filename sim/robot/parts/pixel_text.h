// Reads text on a display of pixels, at scales of one to four. Letters have 5 columns, 7 or 8 rows and an
// empty column after them, as in Adafruit's GFX and most small fonts. Other fonts, and dark letters on a lit
// background, are not read.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace robosim::robot {

/// A picture, row by row from the top.
struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> lit;  ///< 0 or 1

  bool at(int x, int y) const {
    return x >= 0 && x < width && y >= 0 && y < height && lit[static_cast<std::size_t>(y * width + x)] != 0;
  }
};

/// Returns the lines of text from top to bottom, joined by '|'; "" if nothing can be read. A line with fewer
/// than two letters or digits counts as a drawing.
std::string text_in(Pixels pixels);

}  // namespace robosim::robot
