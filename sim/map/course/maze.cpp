// Reads micromouse mazes as lines. The middle of a cell is a node, and lines join neighbouring cells without
// a wall between them. Alternatively, the map contains the maze's walls, and its lines are not painted.
#include <fmt/format.h>

#include <algorithm>

#include "sim/base/error.h"
#include "sim/map/course/formats.h"
#include "sim/map/network.h"

namespace robosim::course {
namespace {

constexpr int kMostCells = 256;  // for each side
// Line mazes have 150 mm between lines (LVBots: 5 to 7 inches). A map has one cell of floor between two
// lines.
constexpr double kCell = 0.075;  // m
constexpr int kLines = 2;        // in map cells: distance between neighbouring lines
// With walls, a map's cell is 11.25 mm, a sixteenth of a classic maze's cell of 180 mm. The rules specify
// walls of 12 mm.
constexpr int kWalls = 16;

struct Maze {
  int width = 0, height = 0;
  std::vector<bool> east, north;  // whether each cell has a wall on that side; the south-west cell is first
  std::optional<map::CellAt> start, goal;

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  void resize(int w, int h) {
    width = w;
    height = h;
    east.assign(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), false);
    north = east;
  }
};

// The positions of the maze's cells on the map.
struct Layout {
  int pitch, margin;  // map cells between two middles, and from the map's edge to the first middle
  int height;         // height of the map
  map::CellAt middle(int x, int y) const { return {pitch * x + margin, height - 1 - margin - pitch * y}; }
};

// Adds walls that are one cell thick along the sides of the maze's cells, and around the maze.
void add_walls(const Maze& maze, const Layout& layout, map::Map& map) {
  constexpr int kHalf = kWalls / 2;
  const auto wall = [&](map::CellAt from, int dx, int dy) {
    for (int i = 0; i <= kWalls; ++i)
      map.cells[map.index_of({from.x + i * dx, from.y + i * dy})] = map::Cell::wall;
  };
  for (int y = 0; y < maze.height; ++y)
    for (int x = 0; x < maze.width; ++x) {
      const map::CellAt c = layout.middle(x, y);
      const std::size_t i = maze.index(x, y);
      if (x == 0) wall({c.x - kHalf, c.y - kHalf}, 0, 1);
      if (y == 0) wall({c.x - kHalf, c.y + kHalf}, 1, 0);
      if (maze.east[i] || x + 1 == maze.width) wall({c.x + kHalf, c.y - kHalf}, 0, 1);
      if (maze.north[i] || y + 1 == maze.height) wall({c.x - kHalf, c.y - kHalf}, 1, 0);
    }
}

Imported map_of(const Maze& maze, double walls_m) {
  Imported imported;
  map::Map& map = imported.map;
  const bool walls = walls_m > 0.0;
  Layout layout{walls ? kWalls : kLines, walls ? kWalls / 2 : 2, 0};
  map.cell_m = walls ? walls_m / kWalls : kCell;
  map.width = layout.pitch * (maze.width - 1) + 2 * layout.margin + 1;
  map.height = layout.height = layout.pitch * (maze.height - 1) + 2 * layout.margin + 1;
  map.cells.assign(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height),
                   map::Cell::floor);
  if (walls) {
    map.line_m = std::min(map.line_m, map.cell_m);
    map.light_line = true;  // the floor is black
    add_walls(maze, layout, map);
  }
  const auto at = [&](int x, int y) { return layout.middle(x, y); };
  const auto paint = [&](map::CellAt from, int dx, int dy) {
    for (int i = 0; i <= layout.pitch; ++i)
      map.cells[map.index_of({from.x + i * dx, from.y + i * dy})] = walls ? map::Cell::gap : map::Cell::line;
  };
  for (int y = 0; y < maze.height; ++y)
    for (int x = 0; x < maze.width; ++x) {
      const std::size_t i = maze.index(x, y);
      if (x + 1 < maze.width && !maze.east[i]) paint(at(x, y), 1, 0);
      if (y + 1 < maze.height && !maze.north[i]) paint(at(x, y), 0, -1);
    }
  const auto on_line = [&](const std::optional<map::CellAt>& cell) {
    return cell && map::is_line(map.at(at(cell->x, cell->y)));
  };
  const map::CellAt start = maze.start.value_or(map::CellAt{0, 0});
  if (on_line(start)) {
    const map::CellAt c = at(start.x, start.y);
    map.start = map::Start{c, map::default_facing(map, c)};
  }
  const map::CellAt goal = maze.goal.value_or(map::CellAt{maze.width / 2, maze.height / 2});
  if (std::none_of(map.cells.begin(), map.cells.end(), map::is_line))
    throw InputError("the maze has no passage");
  if (!on_line(goal) || goal == start) return imported;
  map.goal_cell = at(goal.x, goal.y);
  map.stations.push_back({"goal", *map.goal_cell});
  map.goal = "station:goal";
  const std::vector<map::CellAt> lost = map::trace_network(map, map::default_start(map)).unreachable;
  if (std::find(lost.begin(), lost.end(), *map.goal_cell) != lost.end()) {
    map.goal_cell.reset();
    map.stations.clear();
    map.goal.clear();
    imported.remarks.push_back("the maze's goal cannot be reached from its start, so the map has no goal");
  }
  return imported;
}

}  // namespace

Imported read_maze(std::string_view text, const std::string& file, double walls_m) {
  const std::vector<NumberedLine> lines = lines_of(text);
  std::size_t wide = 0;
  for (const NumberedLine& line : lines) wide = std::max(wide, line.text.size());
  const int width = static_cast<int>((std::min<std::size_t>(wide, 4 * kMostCells + 1) - 1 + 3) / 4);
  const int height = static_cast<int>((std::min<std::size_t>(lines.size(), 2 * kMostCells + 1) - 1) / 2);
  if (wide > 4 * kMostCells + 1 || lines.size() > 2 * kMostCells + 1)
    throw InputError({file},
                     fmt::format("the maze is too large: expected at most {0} x {0} cells", kMostCells));
  if (width < 2 || height < 2 || lines.size() % 2 == 0)
    throw InputError(
        {file}, fmt::format("unknown kind of course: expected JSON, numbers, or a maze of 2 H + 1 lines of "
                            "4 W + 1 characters, got {} lines of {}",
                            lines.size(), wide));
  Maze maze;
  maze.resize(width, height);
  // Any character except a blank is a wall. Short lines are open at their ends (mackorone/mms, src/Maze.cpp).
  const auto is_wall = [&](std::size_t row, int column) {
    const std::string_view line = lines[row].text;
    const auto at = static_cast<std::size_t>(column);
    return at < line.size() && line[at] != ' ' && line[at] != '\t';
  };
  const char first = lines[0].text[0];
  if (first != 'o' && first != '+')
    throw InputError(
        {file, lines[0].number, 1},
        fmt::format("unknown kind of course: expected JSON, numbers, or a maze that begins with o or +, got "
                    "“{}”",
                    first >= ' ' && first <= '~' ? std::string(1, first) : "?"));
  for (int y = 0; y < height; ++y) {
    const auto row = static_cast<std::size_t>(2 * (height - 1 - y) + 1);
    for (int x = 0; x < width; ++x) {
      maze.east[maze.index(x, y)] = is_wall(row, 4 * x + 4);
      maze.north[maze.index(x, y)] = is_wall(row - 1, 4 * x + 2);
      const std::string_view line = lines[row].text;
      const auto middle = static_cast<std::size_t>(4 * x + 2);
      if (middle >= line.size()) continue;
      if (line[middle] == 'S') maze.start = map::CellAt{x, y};
      if (line[middle] == 'G' && !maze.goal) maze.goal = map::CellAt{x, y};
    }
  }
  return map_of(maze, walls_m);
}

Imported read_maze_numbers(std::string_view text, const std::string& file, double walls_m) {
  struct Row {
    int x, y;
    bool north, east;
  };
  std::vector<Row> rows;
  Maze maze;
  int width = 0, height = 0;
  for (const NumberedLine& line : lines_of(text)) {
    const std::vector<double> n = numbers_in(line, file);
    const auto in = [&](std::size_t i, double most) {
      return n[i] >= 0.0 && n[i] <= most && n[i] == static_cast<int>(n[i]);
    };
    if (n.size() != 6 || !in(0, kMostCells - 1) || !in(1, kMostCells - 1) || !in(2, 1) || !in(3, 1) ||
        !in(4, 1) || !in(5, 1))
      throw InputError(
          {file, line.number},
          fmt::format("the maze's cell: expected x y N E S W, with x and y from 0 to {} and walls 0 or 1",
                      kMostCells - 1));
    rows.push_back({static_cast<int>(n[0]), static_cast<int>(n[1]), n[2] > 0.0, n[3] > 0.0});
    width = std::max(width, rows.back().x + 1);
    height = std::max(height, rows.back().y + 1);
  }
  if (rows.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    throw InputError({file}, fmt::format("a maze of {} x {} cells: expected {} cells, got {}", width, height,
                                         width * height, rows.size()));
  maze.resize(width, height);
  for (const Row& row : rows) {
    maze.east[maze.index(row.x, row.y)] = row.east;
    maze.north[maze.index(row.x, row.y)] = row.north;
  }
  return map_of(maze, walls_m);
}

}  // namespace robosim::course
