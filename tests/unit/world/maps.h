// Creates small maps for this folder's tests without the map reader.
#pragma once

#include <string>
#include <vector>

#include "sim/grid/map.h"

namespace robosim::world {

/// Returns a map with one character per cell: ' ' floor, '.' line, '#' wall, 'o' gap, 'x' obstacle.
inline grid::Map map_of(const std::vector<std::string>& rows) {
  grid::Map map;
  map.file = "test.map";
  map.height = static_cast<int>(rows.size());
  map.width = static_cast<int>(rows[0].size());
  for (const std::string& row : rows) {
    for (const char c : row) {
      map.cells.push_back(c == '.'   ? grid::Cell::line
                          : c == '#' ? grid::Cell::wall
                          : c == 'o' ? grid::Cell::gap
                          : c == 'x' ? grid::Cell::obstacle
                                     : grid::Cell::floor);
    }
  }
  return map;
}

/// Returns a map of empty floor.
inline grid::Map empty_map(int width, int height) {
  return map_of(std::vector<std::string>(static_cast<std::size_t>(height),
                                         std::string(static_cast<std::size_t>(width), ' ')));
}

}  // namespace robosim::world
