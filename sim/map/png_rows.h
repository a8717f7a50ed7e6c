// Decodes a PNG row by row. An implementation detail of FloorImage.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace robosim::map {

/// Calls begin(width, height) once, then row(pixels) for each row from the top. A pixel is 0 (black) to 255
/// (white). Throws InputError, which names `file`. Uses memory for one row only, whatever the file contains.
void read_png(std::string_view bytes, const std::string& file, const std::function<void(int, int)>& begin,
              const std::function<void(std::span<const unsigned char>)>& row);

}  // namespace robosim::map
