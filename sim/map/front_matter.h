// Reads the front matter: the TOML between the two +++ lines of a map file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/error.h"
#include "sim/map/legend.h"
#include "sim/map/map.h"
#include "sim/map/sampled_parameters.h"

namespace robosim::map {

/// The content of the front matter with its places in the file. It is not yet checked against the cells.
struct FrontMatter {
  struct PlacedCell {
    CellAt cell;
    Place place;
  };
  struct PlacedStart {
    std::optional<CellAt> cell;  ///< nullopt = the S in the map
    std::optional<OnPath> on_path;
    std::optional<Direction> facing;
    Place place;
  };
  struct PlacedStation {
    NamedStation station;
    Place place;
  };

  Map settings;              ///< contains only the values that do not depend on the cells
  std::optional<Vec2> size;  ///< width and height in m of a floor without rows
  Place size_place;
  std::string picture;  ///< name of the file; "" = none
  Place picture_place;
  double pixel_m = 0.0;
  std::optional<PlacedStart> start;
  std::optional<PlacedCell> goal_cell;
  std::vector<PlacedStation> stations;
  Legend legend;
};

/// Reads the text between the +++ lines; `first_line` is the line of the file on which it begins. Throws
/// InputError.
FrontMatter read_front_matter(std::string_view text, const std::string& file, int first_line, Draw draw = {});

/// Checks that the picture is at least as large as the line's width, and fits on the floor. Checks that the
/// map has no other paint. Throws InputError at `place`.
void check_picture(const Map& map, const Place& place);

/// Throws InputError at `place` if the cell is outside the map or not a line cell. `what` names the cell's
/// purpose in the message, such as "the start".
void require_line(const Map& map, CellAt cell, const Place& place, const std::string& what);

}  // namespace robosim::map
