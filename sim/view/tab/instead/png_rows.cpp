// Replaces the reader of PNG files, which needs libpng. Maps with a picture are refused.
#include "sim/map/png_rows.h"

#include "sim/base/error.h"

namespace robosim::map {

void read_png(std::string_view, const std::string& file, const std::function<void(int, int)>&,
              const std::function<void(std::span<const unsigned char>)>&) {
  throw InputError({file},
                   "is a map with a picture, which a browser's tab cannot read: run it by `robosim run`");
}

}  // namespace robosim::map
