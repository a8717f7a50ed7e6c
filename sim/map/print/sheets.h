// Divides a floor into adjacent sheets of paper.
//
// Each sheet shows its own piece of the floor (net_width x net_height) with a flap around it. The flap shows
// another 10 mm of the floor on each side. The next sheet is laid on the flap. Sheets are counted from the
// floor's upper left corner. Lengths are in mm, x east and y north from the floor's lower left corner.
#pragma once

#include <string>
#include <vector>

#include "sim/map/map.h"
#include "sim/map/print/shapes.h"

namespace robosim::print {

struct Paper {
  double width = 210.0, height = 297.0;  ///< mm
};

constexpr double kFlap = 10.0;        ///< in mm
constexpr double kMostMargin = 40.0;  ///< in mm; with this margin, the bar of 100 mm still fits on A4
constexpr std::size_t kMostSheets = 400;

struct Sheet {
  int row, column;  ///< from 1
};

struct Sheets {
  Paper paper;                 ///< portrait or landscape
  double margin = 0.0;         ///< distance from the paper's edge to the flap in mm
  double width = 0.0;          ///< width of the floor in mm
  double height = 0.0;         ///< height of the floor in mm
  int rows = 0, columns = 0;   ///< for the whole floor
  std::vector<Sheet> printed;  ///< the sheets with any paint, row by row

  double net_width() const { return paper.width - 2.0 * (margin + kFlap); }
  double net_height() const { return paper.height - 2.0 * (margin + kFlap); }
  /// Returns a sheet's own piece of the floor; it may reach beyond the floor.
  Box piece(Sheet sheet) const {
    const double left = (sheet.column - 1) * net_width(), top = height - (sheet.row - 1) * net_height();
    return {left, top - net_height(), left + net_width(), top};
  }
};

/// Divides the floor with the paper in portrait or landscape, whichever needs fewer sheets. If `dark_floor`
/// is true, the floor itself is painted, too. Throws InputError if more than kMostSheets are needed.
Sheets divide(const map::Map& map, const Shapes& shapes, Paper paper, double margin, bool dark_floor);

}  // namespace robosim::print
