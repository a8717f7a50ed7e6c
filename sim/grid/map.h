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
#include "sim/grid/course.h"
#include "sim/grid/light.h"

namespace robosim::grid {

class FloorImage;

enum class Cell : std::uint8_t {
  floor = 0,
  line = 1,
  wall = 2,
  gap = 3,       ///< part of the line network, but not painted (legend only)
  obstacle = 4,  ///< line with an obstacle standing on it
};

constexpr bool is_line(Cell c) { return c == Cell::line || c == Cell::gap || c == Cell::obstacle; }

/// A cell by column and row from the top-left corner, as users type them.
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
  int path = 0;            ///< its index in Course::paths
  double along = 0.0;      ///< m from the path's beginning
  bool backwards = false;  ///< facing against its direction
  bool operator==(const OnPath&) const = default;
};

/// Where a robot starts.
struct Start {
  CellAt cell;
  Direction facing = Direction::east;
  /// Set if it begins on a path; `cell` is then the cell below it, and `facing` the nearest direction.
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
  std::string name;                             ///< front matter, else the file's stem
  int width = 0;                                ///< cells
  int height = 0;                               ///< cells
  std::vector<Cell> cells;                      ///< row by row from the top
  std::vector<SurfaceFigures> legend_surfaces;  ///< of [legend]
  /// For each cell 1 + its index in legend_surfaces, 0 = the usual floor; empty if all are that.
  std::vector<std::uint8_t> surface_of_cell;
  double cell_m = 0.100;    ///< side of a cell
  double line_m = 0.020;    ///< width of the stripe
  double corner_m = 0.0;    ///< radius that replaces each bend; 0 = square
  bool raster = false;      ///< floor = "raster": whole cells are painted, instead of stripes
  bool light_line = false;  ///< paint = "white on black"
  /// Standard deviation of the floor's brightness, as a share of it; none: the profile's.
  std::optional<double> variation;
  double worn = 0.0;  ///< the share of all lines and marks that is gone, where they say no other: Paint::worn
  double gloss = 0.0;  ///< of the floor and what is painted on it, where that says no other: Paint::gloss
  std::vector<Light> lights;  ///< of the room, beside the sensors' own
  /// floor = "NAME.png": the painted picture. Cells and paths then only define where the line is.
  std::shared_ptr<const FloorImage> image;
  Course course;               ///< paths and marks, beside the cells
  std::optional<Start> start;  ///< from [start] or S
  /// The front matter's goal, "" = none. A map with a goal cell and no goal of its own gets "station:NAME",
  /// NAME being the station on that cell ("goal", unless [stations] names it).
  std::string goal;
  Place goal_place;                 ///< where `goal` was written
  std::optional<CellAt> goal_cell;  ///< from G or [goal]; it is among `stations` too
  std::vector<NamedStation> stations;
  std::string generator;  ///< name, version and seed, where a generator wrote the map
  /// SHA-256 of the text, followed by a picture's file; read_map leaves it empty for large files: see
  /// sha256_of.
  std::string sha256;
  bool differs = false;  ///< by the seed of the Draw: some of its figures have a spread

  bool contains(CellAt c) const { return c.x >= 0 && c.y >= 0 && c.x < width && c.y < height; }
  /// Returns a cell; outside the map everything is wall.
  Cell at(CellAt c) const {
    if (!contains(c)) return Cell::wall;
    return cells[index_of(c)];
  }
  /// Returns the index of a cell of the map in `cells`.
  std::size_t index_of(CellAt c) const {
    return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(c.x);
  }
  /// Returns surface_of_cell of a cell by its index in `cells`.
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

/// Limits of a map's columns and rows, and of its cells.
constexpr int kMaxSide = 100'000;
constexpr std::size_t kMaxCells = 64'000'000;  ///< a command and its runner take 3 bytes for each
/// The limit of cells for a map that is not written in rows, so that a short file cannot take much memory.
constexpr std::size_t kMaxBareCells = 4'000'000;

/// Reads a map file, in one pass and at one byte per cell. `draw` selects the values of parameters with a
/// spread. Throws InputError with file, line, column, what was found and what is allowed.
Map read_map(const std::filesystem::path& path, Draw draw = {});
/// Parses a map from text. `file` is for messages; a picture is next to it, unless `picture` has its bytes.
Map parse_map(std::string_view text, const std::string& file, const std::string& picture = "",
              Draw draw = {});

/// Returns SHA-256 of the map's text, followed by its picture's file. Hashing takes several times as long as
/// reading, so read_map hashes small files only (up to 256 KB). For a larger one this reads the file again.
/// Throws InputError if it is gone.
std::string sha256_of(const Map& map);
/// Hashes a map's file and understands only its front matter. Throws InputError.
std::string sha256_of_map(const std::filesystem::path& path);

/// Finds a map by what users type: a path if it contains '/' or '.', else the sample map of that name. Throws
/// InputError naming the available samples.
std::filesystem::path find_map(const std::string& name);

/// Returns the directions in which a cell has a neighbouring line cell: bit 1 << Direction.
inline unsigned line_neighbours(const Map& map, CellAt c) {
  unsigned mask = 0;
  for (int d = 0; d < 4; ++d)
    if (is_line(map.at(ahead(c, static_cast<Direction>(d))))) mask |= 1u << d;
  return mask;
}

constexpr bool has(unsigned mask, Direction d) { return (mask >> static_cast<int>(d) & 1u) != 0; }

/// Returns whether an obstacle stands on the line right ahead of a robot on a line cell: an `x`, or a wall
/// that was put on the line. Such a wall is straight ahead of a line's end and has line right behind it. A
/// wall next to a continuing line is just a wall, and so is every wall around a single line cell.
inline bool blocks_line(const Map& map, CellAt c, Direction d) {
  const CellAt next = ahead(c, d);
  const Cell what = map.at(next);
  if (what != Cell::wall) return what == Cell::obstacle;
  return is_line(map.at(ahead(next, d))) && line_neighbours(map, c) == 1u << static_cast<int>(reversed(d));
}

/// Returns whether a line ends on this line cell, so that it is a station: no neighbouring line, or on one
/// side only and no obstacle on the opposite one.
inline bool is_dead_end(const Map& map, CellAt c) {
  const unsigned lines = line_neighbours(map, c);
  if (lines == 0) return true;
  if (!std::has_single_bit(lines)) return false;
  return !blocks_line(map, c, reversed(static_cast<Direction>(std::countr_zero(lines))));
}

/// Returns how a robot faces on a line cell: towards its only line neighbour, or the first in the order E S W
/// N.
Direction default_facing(const Map& map, CellAt cell);

/// Parses "13,2,E", or "13,2" with the default facing. On a map with a path, "1.2m" is a place along the
/// first one; "1.2m,back" faces backward. Throws InputError.
Start parse_start(const Map& map, std::string_view text);
/// Returns the default start: [start] or S; else the beginning of the first path; else the first dead end in
/// row order; else the first line cell. It faces its only line neighbour, or the first in the order E S W N.
/// Throws InputError if the map has no line.
Start default_start(const Map& map);
/// Returns the position on a path, and the heading of a robot there.
Pose path_pose(const Map& map, const OnPath& on);
/// Returns a start on a path of the map.
Start start_on(const Map& map, const OnPath& on);
/// Throws InputError if the start is on a path, for `what`, which supports cells only.
void require_cells(const Map& map, const Start& start, const char* what);

}  // namespace robosim::grid
