// A map: a grid of cells read from text, and what its front matter says. The format is in docs/maps.md.
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

/// Clockwise, as they lie on the map (y grows southward).
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
/// 'E', 'S', 'W' or 'N'.
constexpr char letter(Direction d) { return "ESWN"[static_cast<int>(d)]; }
/// The direction as a unit vector of the world frame (y north).
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

/// Where a robot begins.
struct Start {
  CellAt cell;
  Direction facing = Direction::east;
  /// Set if it begins on a path; `cell` is then the one that it stands over, and `facing` the nearest.
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
  /// Of each cell 1 + its index in legend_surfaces, 0 = the floor as usual; empty where all are that.
  std::vector<std::uint8_t> surface_of_cell;
  double cell_m = 0.100;    ///< side of a cell
  double line_m = 0.020;    ///< width of the stripe
  double corner_m = 0.0;    ///< radius that replaces each bend; 0 = square
  bool raster = false;      ///< floor = "raster": whole cells are painted, instead of stripes
  bool light_line = false;  ///< paint = "white on black"
  /// Standard deviation of the floor's brightness, as a share of it; none: what the profile has.
  std::optional<double> variation;
  double worn = 0.0;  ///< the share of all lines and marks that is gone, where they say no other: Paint::worn
  double gloss = 0.0;  ///< of the floor and what is painted on it, where that says no other: Paint::gloss
  std::vector<Light> lights;  ///< of the room, beside the sensors' own
  /// floor = "NAME.png": what is painted. Then cells and paths say where the line is, and paint nothing.
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
  /// Of the text, and of a picture's file behind it; read_map leaves it empty for large files: see sha256_of.
  std::string sha256;
  bool differs = false;  ///< by the seed of the Draw: some of its figures have a spread

  bool contains(CellAt c) const { return c.x >= 0 && c.y >= 0 && c.x < width && c.y < height; }
  /// Outside the map everything is wall.
  Cell at(CellAt c) const {
    if (!contains(c)) return Cell::wall;
    return cells[index_of(c)];
  }
  /// The place of a cell of the map in `cells`.
  std::size_t index_of(CellAt c) const {
    return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(c.x);
  }
  /// Of a cell by its place in `cells`: as surface_of_cell has it.
  std::uint8_t surface_at(std::size_t index) const {
    return surface_of_cell.empty() ? std::uint8_t{0} : surface_of_cell[index];
  }
  /// The inverse of index_of.
  CellAt cell_at(std::size_t index) const {
    const auto columns = static_cast<std::size_t>(width);
    return {static_cast<int>(index % columns), static_cast<int>(index / columns)};
  }
  /// The centre of a cell in the world frame: metres, x east, y north, origin at the map's bottom-left
  /// corner.
  Vec2 centre(CellAt c) const { return {(c.x + 0.5) * cell_m, (height - 1 - c.y + 0.5) * cell_m}; }
};

/// A map has at most this many columns and rows, and cells in all.
constexpr int kMaxSide = 100'000;
constexpr std::size_t kMaxCells = 1'000'000'000;
/// And so many where it is not written in rows, so that a short file cannot take much memory.
constexpr std::size_t kMaxBareCells = 4'000'000;

/// Reads a map file, in one pass and at one byte a cell. `draw`: whose are its figures with a spread. Throws
/// InputError with file, line, column, what was found and what is allowed.
Map read_map(const std::filesystem::path& path, Draw draw = {});
/// The same from text; `file` is for messages, and a picture lies beside it, unless its bytes are given here.
Map parse_map(std::string_view text, const std::string& file, const std::string& picture = "",
              Draw draw = {});

/// SHA-256 of the map's text, and of its picture's file behind it. Hashing takes several times as long as
/// reading, so read_map hashes small files only (up to 256 KB); for a larger one this reads the file again.
/// Throws InputError if it is gone.
std::string sha256_of(const Map& map);
/// The same of a map's file, of which no more than the front matter is understood. Throws InputError.
std::string sha256_of_map(const std::filesystem::path& path);

/// A map by what users type: a path if it holds '/' or '.', else the sample map of that name. Throws
/// InputError naming the samples that exist.
std::filesystem::path find_map(const std::string& name);

/// The directions in which a cell has a line cell beside it: bit 1 << Direction.
inline unsigned line_neighbours(const Map& map, CellAt c) {
  unsigned mask = 0;
  for (int d = 0; d < 4; ++d)
    if (is_line(map.at(ahead(c, static_cast<Direction>(d))))) mask |= 1u << d;
  return mask;
}

constexpr bool has(unsigned mask, Direction d) { return (mask >> static_cast<int>(d) & 1u) != 0; }

/// Whether an obstacle stands on the line right ahead of a robot on a line cell: an `x`, or a wall that was
/// put on the line. Of the latter kind is a wall straight ahead of a line's end that has line right behind
/// it; a wall beside a line that goes on is just a wall, and so is every wall around a single line cell.
inline bool blocks_line(const Map& map, CellAt c, Direction d) {
  const CellAt next = ahead(c, d);
  const Cell what = map.at(next);
  if (what != Cell::wall) return what == Cell::obstacle;
  return is_line(map.at(ahead(next, d))) && line_neighbours(map, c) == 1u << static_cast<int>(reversed(d));
}

/// Whether a line ends on this line cell, so that it is a station: no line beside it, or on one side only and
/// no obstacle at the other.
inline bool is_dead_end(const Map& map, CellAt c) {
  const unsigned lines = line_neighbours(map, c);
  if (lines == 0) return true;
  if (!std::has_single_bit(lines)) return false;
  return !blocks_line(map, c, reversed(static_cast<Direction>(std::countr_zero(lines))));
}

/// How a robot put on a line cell faces: towards its only line neighbour, or the first in the order E S W N.
Direction default_facing(const Map& map, CellAt cell);

/// "13,2,E" or "13,2" (then the facing rule applies); on a map with a path "1.2m", so far along the first
/// one, or "1.2m,back". Throws InputError.
Start parse_start(const Map& map, std::string_view text);
/// The start by DESIGN's rule: [start] or S, else the beginning of the first path, else the first dead end in
/// row order, else the first line cell; facing its only line neighbour, or the first in the order E S W N.
/// Throws InputError if the map has no line.
Start default_start(const Map& map);
/// Where that is, and which way a robot there faces.
Pose path_pose(const Map& map, const OnPath& on);
/// A start on a path of the map.
Start start_on(const Map& map, const OnPath& on);
/// For what knows cells only. Throws InputError if the start is on a path.
void require_cells(const Map& map, const Start& start, const char* what);

}  // namespace robosim::grid
