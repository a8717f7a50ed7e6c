// A map's floor as a PDF in true size, to be laid on the floor in sheets.
#pragma once

#include <string>

#include "sim/grid/map.h"
#include "sim/print/sheets.h"

namespace robosim::print {

struct Options {
  Paper paper;
  double margin = 5.0;  ///< mm that the printer leaves white
  /// What is white on black is printed as black on white; pictures are printed as they are.
  bool swapped = false;
  bool compressed = true;  ///< the pages' contents
};

struct Printed {
  std::string pdf;
  Sheets sheets;
};

/// The first page is an overview with the sheets' numbers; then a page for each sheet: what is painted on its
/// piece of the floor, as the simulation measures it (round ends, gaps, arcs), thin outlines where walls and
/// obstacles stand, marks to cut along, its number, and a bar of 100 mm to check the printer by. Throws
/// InputError if it takes too many sheets, ToolMissing in a build that cannot write PDF.
Printed print_map(const grid::Map& map, const Options& options);

}  // namespace robosim::print
