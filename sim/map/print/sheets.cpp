#include "sim/map/print/sheets.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "sim/base/error.h"

namespace robosim::print {
namespace {

constexpr double kWorthLooking = 20'000.0;  // in sheets: larger floors are rejected without examining them

Sheets divided(const map::Map& map, const Shapes& shapes, Paper paper, double margin, bool dark_floor) {
  Sheets sheets;
  sheets.paper = paper;
  sheets.margin = margin;
  sheets.width = map.width * map.cell_m * 1e3;
  sheets.height = map.height * map.cell_m * 1e3;
  const double columns = std::ceil(sheets.width / sheets.net_width() - 1e-9);
  const double rows = std::ceil(sheets.height / sheets.net_height() - 1e-9);
  if (rows * columns > kWorthLooking)
    throw InputError(
        {map.file},
        fmt::format("its floor of {:.1f} x {:.1f} m is {:.0f} pages of this paper; at most {} are "
                    "printed",
                    sheets.width * 1e-3, sheets.height * 1e-3, rows * columns, kMostSheets));
  sheets.rows = static_cast<int>(rows);
  sheets.columns = static_cast<int>(columns);
  for (int row = 1; row <= sheets.rows; ++row)
    for (int column = 1; column <= sheets.columns; ++column)
      if (dark_floor || shapes.paints(sheets.piece({row, column}))) sheets.printed.push_back({row, column});
  return sheets;
}

}  // namespace

Sheets divide(const map::Map& map, const Shapes& shapes, Paper paper, double margin, bool dark_floor) {
  Sheets upright = divided(map, shapes, paper, margin, dark_floor);
  Sheets aside = divided(map, shapes, {paper.height, paper.width}, margin, dark_floor);
  Sheets& sheets = aside.printed.size() < upright.printed.size() ? aside : upright;
  if (sheets.printed.size() > kMostSheets)
    throw InputError({map.file}, fmt::format("takes {} pages of this paper{}; at most {} are printed",
                                             sheets.printed.size(), dark_floor ? " with its dark floor" : "",
                                             kMostSheets));
  return std::move(sheets);
}

}  // namespace robosim::print
