// Creates small maps for this folder's tests without the map reader.
#pragma once

#include <string>
#include <vector>

#include "sim/map/map.h"

namespace robosim::world {

/// Returns a map with one character per cell: ' ' floor, '.' line, '#' wall, 'o' gap, 'x' obstacle.
inline map::Map map_of(const std::vector<std::string>& rows) {
  map::Map map;
  map.file = "test.map";
  map.height = static_cast<int>(rows.size());
  map.width = static_cast<int>(rows[0].size());
  for (const std::string& row : rows) {
    for (const char c : row) {
      map.cells.push_back(c == '.'   ? map::Cell::line
                          : c == '#' ? map::Cell::wall
                          : c == 'o' ? map::Cell::gap
                          : c == 'x' ? map::Cell::obstacle
                                     : map::Cell::floor);
    }
  }
  return map;
}

/// Returns a map of empty floor.
inline map::Map empty_map(int width, int height) {
  return map_of(std::vector<std::string>(static_cast<std::size_t>(height),
                                         std::string(static_cast<std::size_t>(width), ' ')));
}

}  // namespace robosim::world
