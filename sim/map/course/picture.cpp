// Imports a picture as the floor of a map (import.h).
#include <cmath>

#include "sim/map/course/import.h"
#include "sim/map/floor_image.h"

namespace robosim::course {

bool is_picture(std::string_view bytes) { return bytes.starts_with("\x89PNG\r\n\x1a\n"); }

Imported import_picture(std::string png, const std::string& file, const std::string& name, double pixel_m) {
  Imported imported;
  map::Map& map = imported.map;
  map.name = name;
  map.image = std::make_shared<const map::FloorImage>(std::move(png), file, pixel_m);
  const double wide = map.image->wide_m(), high = map.image->high_m();
  map.width = static_cast<int>(std::ceil(wide / map.cell_m - 1e-9));
  map.height = static_cast<int>(std::ceil(high / map.cell_m - 1e-9));
  const auto cells = static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height);
  if (cells > map::kMaxBareCells)
    throw InputError({file},
                     "the picture is too large for the floor of a map; check --pixel, the side of a pixel");
  map.cells.assign(cells, map::Cell::floor);
  map.light_line = map.image->darkness_in({0.0, 0.0}, {wide, high}) > 0.5;
  imported.remarks.push_back(
      "the course of the line is not read from the picture: add a [[path]] (docs/reference/maps.md) before "
      "you run a robot there, because start, laps, cross-track error and “lost” are measured along it");
  return imported;
}

}  // namespace robosim::course
