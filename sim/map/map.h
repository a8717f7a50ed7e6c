// A map: a grid of cells read from text, and the content of its front matter. The format is in
// docs/reference/maps.md.
#pragma once

#include <bit>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/error.h"
#include "sim/base/vec.h"
#include "sim/map/course.h"
#include "sim/map/light.h"

namespace robosim::map {

class FloorImage;

enum class Cell : std::uint8_t {
  floor = 0,
  line = 1,
  wall = 2,
  gap = 3,       ///< part of the line network, but not painted (legend only)
  obstacle = 4,  ///< line with an obstacle standing on it
};

constexpr bool is_line(Cell c) { return c == Cell::line || c == Cell::gap || c == Cell::obstacle; }

/// A cell by column and row from the top-left corner, as in user input.
struct CellAt {
  int x = 0;
  int y = 0;
  bool operator==(const CellAt&) const = default;
};

/// Directions, clockwise on the map (y grows southward).
enum class Direction : std::uint8_t { east, south, west, north };

constexpr Direction turned_right(Direction d) {
  return static_cast<Direction>((static_cast<int>(d) + 1) & 3);
}
constexpr Direction turned_left(Direction d) { return static_cast<Direction>((static_cast<int>(d) + 3) & 3); }
constexpr Direction reversed(Direction d) { return static_cast<Direction>((static_cast<int>(d) + 2) & 3); }
constexpr CellAt ahead(CellAt c, Direction d) {
  constexpr int dx[] = {1, 0, -1, 0};
  constexpr int dy[] = {0, 1, 0, -1};
  return {c.x + dx[static_cast<int>(d)], c.y + dy[static_cast<int>(d)]};
}
/// Returns 'E', 'S', 'W' or 'N'.
constexpr char letter(Direction d) { return "ESWN"[static_cast<int>(d)]; }
/// Returns the direction as a unit vector of the world frame (y north).
constexpr Vec2 heading(Direction d) {
  constexpr Vec2 of[] = {{1, 0}, {0, -1}, {-1, 0}, {0, 1}};
  return of[static_cast<int>(d)];
}

/// A place on one of a map's paths.
struct OnPath {
  int path = 0;            ///< index in Course::paths
  double along = 0.0;      ///< in m: distance along the path from its beginning
  bool backwards = false;  ///< facing against the path's direction
  bool operator==(const OnPath&) const = default;
};

/// The start of a robot.
struct Start {
  CellAt cell;
  Direction facing = Direction::east;
  /// Set if the robot starts on a path. `cell` is then the cell below the robot, and `facing` the nearest
  /// direction.
  std::optional<OnPath> on_path = std::nullopt;
  bool operator==(const Start&) const = default;
};

/// A station named in the map's front matter.
struct NamedStation {
  std::string name;
  CellAt cell;
};

struct Map {
  std::string file;                             ///< as the user named it; for messages
  std::string name;                             ///< from the front matter, else the file's stem
  int width = 0;                                ///< in cells
  int height = 0;                               ///< in cells
  std::vector<Cell> cells;                      ///< row by row from the top
  std::vector<SurfaceFigures> legend_surfaces;  ///< surfaces of [legend]
  /// For each cell, 1 + the index of its surface in legend_surfaces; 0 = the usual floor. Empty if all cells
  /// are usual floor.
  std::vector<std::uint8_t> surface_of_cell;
  double cell_m = 0.100;    ///< side of a cell
  double line_m = 0.020;    ///< width of the stripe
  double corner_m = 0.0;    ///< radius of the arc that replaces each bend; 0 = square
  bool raster = false;      ///< floor = "raster": whole cells are painted, instead of stripes
  bool light_line = false;  ///< paint = "white on black"
  /// Standard deviation of the floor's brightness, as a share of the brightness; nullopt = the value of the
  /// profile.
  std::optional<double> variation;
  double worn = 0.0;          ///< default Paint::worn of lines and marks
  double gloss = 0.0;         ///< default Paint::gloss of the floor and everything painted on it
  std::vector<Light> lights;  ///< ambient light
  /// floor = "NAME.png": the painted picture. In this case, cells and paths only define where the line is.
  std::shared_ptr<const FloorImage> image;
  Course course;               ///< everything except the cells, such as paths and marks
  std::optional<Start> start;  ///< from [start] or S
  /// The front matter's goal; "" = none. If the front matter has no goal, but the map has a goal cell, this
  /// is "station:NAME". NAME is the goal cell's name in [stations], or else "goal".
  std::string goal;
  Place goal_place;                 ///< where `goal` was written
  std::optional<CellAt> goal_cell;  ///< from G or [goal]; also one of `stations`
  std::vector<NamedStation> stations;
  std::string generator;  ///< name, version and seed, if a generator made the map
  /// SHA-256 of the map's text, followed by its picture's file. read_map() leaves this empty for large files;
  /// see sha256_of().
  std::string sha256;
  bool differs = false;  ///< the map depends on the seed of the Draw, since some parameters have a spread

  bool contains(CellAt c) const { return c.x >= 0 && c.y >= 0 && c.x < width && c.y < height; }
  /// Returns a cell; outside the map everything is wall.
  Cell at(CellAt c) const {
    if (!contains(c)) return Cell::wall;
    return cells[index_of(c)];
  }
  /// Returns the index in `cells` of a cell inside the map.
  std::size_t index_of(CellAt c) const {
    return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(c.x);
  }
  /// Returns the surface of the cell at an index in `cells`, as in surface_of_cell.
  std::uint8_t surface_at(std::size_t index) const {
    return surface_of_cell.empty() ? std::uint8_t{0} : surface_of_cell[index];
  }
  /// Returns the cell at an index in `cells`.
  CellAt cell_at(std::size_t index) const {
    const auto columns = static_cast<std::size_t>(width);
    return {static_cast<int>(index % columns), static_cast<int>(index / columns)};
  }
  /// Returns the centre of a cell in the world frame: metres, x east, y north, origin at the map's
  /// bottom-left corner.
  Vec2 centre(CellAt c) const { return {(c.x + 0.5) * cell_m, (height - 1 - c.y + 0.5) * cell_m}; }
};

/// Maximum number of columns, and of rows.
constexpr int kMaxSide = 100'000;
/// Maximum number of cells. A command and the runner process that it starts use 3 bytes per cell.
constexpr std::size_t kMaxCells = 64'000'000;
/// Maximum number of cells of a map without rows, so that a short file cannot use much memory.
constexpr std::size_t kMaxBareCells = 4'000'000;

/// Reads a map file in one pass, using one byte per cell. `draw` selects the values of parameters with a
/// spread. Throws InputError with file, line and column, the unexpected text, and the allowed values.
Map read_map(const std::filesystem::path& path, Draw draw = {});
/// Parses a map from text. `file` is for messages. A picture is read from the file's folder, unless `picture`
/// contains its bytes.
Map parse_map(std::string_view text, const std::string& file, const std::string& picture = "",
              Draw draw = {});

/// Returns the SHA-256 of the map's text, followed by its picture's file. Reads a file of more than 256 KB
/// again: read_map() hashes only smaller files, since hashing takes several times as long as reading. Throws
/// InputError if the file is gone.
std::string sha256_of(const Map& map);
/// Returns the SHA-256 of a map's file, followed by its picture's file. Parses only the front matter. Throws
/// InputError.
std::string sha256_of_map(const std::filesystem::path& path);

/// Finds a map by a path, which contains '/' or '.', or by the name of a sample map. Throws InputError with a
/// list of the sample maps.
std::filesystem::path find_map(const std::string& name);

/// Returns the directions in which a cell has a neighbouring line cell: bit 1 << Direction.
inline unsigned line_neighbours(const Map& map, CellAt c) {
  unsigned mask = 0;
  for (int d = 0; d < 4; ++d)
    if (is_line(map.at(ahead(c, static_cast<Direction>(d))))) mask |= 1u << d;
  return mask;
}

constexpr bool has(unsigned mask, Direction d) { return (mask >> static_cast<int>(d) & 1u) != 0; }

/// Returns whether an obstacle blocks the line directly ahead of a robot on a line cell. An obstacle is an
/// `x`, or a wall placed on the line. Such a wall is straight ahead of a line's end, and the line continues
/// directly after the wall. A wall next to a continuing line, or around a single line cell, is not an
/// obstacle.
inline bool blocks_line(const Map& map, CellAt c, Direction d) {
  const CellAt next = ahead(c, d);
  const Cell what = map.at(next);
  if (what != Cell::wall) return what == Cell::obstacle;
  return is_line(map.at(ahead(next, d))) && line_neighbours(map, c) == 1u << static_cast<int>(reversed(d));
}

/// Returns whether a line ends on this line cell, which makes the cell a station. Such a cell has at most one
/// neighbouring line cell. If it has one, no obstacle is on the opposite side.
inline bool is_dead_end(const Map& map, CellAt c) {
  const unsigned lines = line_neighbours(map, c);
  if (lines == 0) return true;
  if (!std::has_single_bit(lines)) return false;
  return !blocks_line(map, c, reversed(static_cast<Direction>(std::countr_zero(lines))));
}

/// Returns the default direction of a robot on a line cell: towards the first line neighbour in the order E S
/// W N.
Direction default_facing(const Map& map, CellAt cell);

/// Parses "13,2,E", or "13,2" with the default facing. On a map with a path, "1.2m" is a place along the
/// first path; "1.2m,back" faces backward. Throws InputError.
Start parse_start(const Map& map, std::string_view text);
/// Returns the default start: [start] or S; else the beginning of the first path; else the first dead end in
/// row order; else the first line cell. If a start on a cell has no direction, uses default_facing().
/// Throws InputError if the map has no line.
Start default_start(const Map& map);
/// Returns the pose of a robot at a place on a path.
Pose path_pose(const Map& map, const OnPath& on);
/// Returns a start on a path of the map.
Start start_on(const Map& map, const OnPath& on);
/// Throws InputError if the start is on a path. `what` names the feature that supports only cells.
void require_cells(const Map& map, const Start& start, const char* what);

}  // namespace robosim::map
