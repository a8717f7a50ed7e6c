// Prints a map's floor as a PDF in true size, as sheets to lay on the floor.
#pragma once

#include <string>

#include "sim/map/map.h"
#include "sim/map/print/sheets.h"

namespace robosim::print {

struct Options {
  Paper paper;
  double margin = 5.0;  ///< in mm: width of the edge on which the printer cannot print
  /// Prints white on black as black on white. Pictures stay unchanged.
  bool swapped = false;
  bool compressed = true;  ///< compresses the pages' contents
};

struct Printed {
  std::string pdf;
  Sheets sheets;
};

/// Prints a map. The first page is an overview with the sheets' numbers. The other pages are sheets. Each
/// sheet shows the paint on its piece of the floor, as the simulation measures it (round ends, gaps, arcs).
/// It also shows thin outlines of walls and obstacles. Each sheet has marks to cut along, its number, and a
/// bar of 100 mm to check the printer. Throws InputError if there are too many sheets, and ToolMissing in a
/// build that cannot write PDF.
Printed print_map(const map::Map& map, const Options& options);

}  // namespace robosim::print
