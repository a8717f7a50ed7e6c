// Reads and writes the [legend] of a map, which defines the meaning of the digits 3 to 9.
//
//   3 = "gap"                                  # a cell
//   4 = "wet"                                  # a surface: floor that is wet
//   5 = "wet line"                             # both
//   6 = { cell = "line", rolling = 0.03 }      # a surface by its parameters
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/config.h"
#include "sim/map/map.h"
#include "sim/map/sampled_parameters.h"

namespace robosim::map {

struct Legend {
  struct Meaning {
    Cell cell = Cell::floor;
    std::uint8_t surface = 0;  ///< as in Map::surface_of_cell
  };
  std::array<std::optional<Meaning>, 10> digits;  ///< 0 to 2 are never set
  std::vector<SurfaceFigures> surfaces;           ///< as Map::legend_surfaces
};

/// Returns the name that the front matter uses for a kind of cell.
const char* cell_word(Cell cell);

/// Reads [legend]. Throws InputError.
Legend read_legend(const ConfigValue& value, Draw draw = {});

/// Assigns digits to cells that have no character, for writing a map.
class LegendWriter {
 public:
  /// Assigns the digits. Throws std::invalid_argument if seven digits are not enough.
  explicit LegendWriter(const Map& map);

  /// Returns the digit for a kind of cell and a surface. Returns 0 if the cell has its own character, and so
  /// needs no digit.
  char digit(Cell cell, std::size_t surface) const { return digit_[index(cell, surface)]; }
  /// Returns the table [legend], or "".
  const std::string& text() const { return text_; }

 private:
  static std::size_t index(Cell cell, std::size_t surface) {
    return surface * 8 + static_cast<std::size_t>(cell);
  }
  std::vector<char> digit_;
  std::string text_;
};

}  // namespace robosim::map
