#include "sim/map/map_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <utility>

#include "sim/base/file.h"
#include "sim/base/utf8.h"
#include "sim/map/floor_image.h"

namespace robosim::map {
namespace {

constexpr std::string_view kFence = "+++";

// Reads a row that contains only floor, line and wall; returns false for any other row. Compilers vectorise
// the loop, so that large maps are read at the speed of memory.
bool read_plain(std::string_view row, Cell* out) {
  unsigned char strange = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const auto c = static_cast<unsigned char>(row[i]);
    const auto line = static_cast<unsigned char>((c == '1') | (c == '.'));
    const auto wall = static_cast<unsigned char>((c == '2') | (c == '#'));
    const auto floor = static_cast<unsigned char>((c == '0') | (c == ' ') | (c == '_'));
    out[i] = static_cast<Cell>(line | wall << 1);
    strange |= static_cast<unsigned char>((line | wall | floor) ^ 1);
  }
  return strange == 0;
}

// Counts a character, like std::count. Each block's sum fits into a byte, so that compilers vectorise the
// loop.
std::size_t count(std::string_view row, char c) {
  constexpr std::size_t kBlock = 128;
  std::size_t total = 0;
  std::size_t i = 0;
  for (; i + kBlock <= row.size(); i += kBlock) {
    unsigned char found = 0;
    for (std::size_t j = 0; j < kBlock; ++j) found = static_cast<unsigned char>(found + (row[i + j] == c));
    total += found;
  }
  return total +
         static_cast<std::size_t>(std::count(row.begin() + static_cast<std::ptrdiff_t>(i), row.end(), c));
}

}  // namespace

MapParser::MapParser(std::string file, std::size_t size_hint, std::string picture, Draw draw)
    : size_hint_(size_hint), picture_(std::move(picture)), draw_(draw) {
  draw_.differs = &differs_;
  map_.file = std::move(file);
  meaning_.fill(kNothing);
  const auto mean = [this](std::string_view characters, Cell cell) {
    for (const char c : characters) meaning_[static_cast<unsigned char>(c)] = static_cast<std::uint8_t>(cell);
  };
  mean("0 _", Cell::floor);
  mean("1.SG", Cell::line);
  mean("2#", Cell::wall);
  mean("x", Cell::obstacle);
  for (const char c : {'S', 'G'}) meaning_[static_cast<unsigned char>(c)] |= kMark;
}

std::string MapParser::picture_named_in(std::string_view beginning, const std::string& file) {
  beginning = without_byte_order_mark(beginning);
  if (!beginning.starts_with(kFence)) return "";
  MapParser parser(file, 0);
  while (parser.section_ != Section::grid && !beginning.empty()) {
    const std::size_t end = std::min(beginning.find('\n'), beginning.size() - 1) + 1;
    parser.feed(beginning.substr(0, end));
    beginning.remove_prefix(end);
  }
  return parser.front_.picture;
}

void MapParser::load_picture() {
  const auto place = std::filesystem::path(map_.file).parent_path() / front_.picture;
  try {
    if (picture_.empty()) picture_ = read_file(place, FloorImage::kMostFile_bytes);
  } catch (const InputError& error) {
    throw InputError(front_.picture_place, fmt::format("the picture {} {}", front_.picture, error.message()));
  }
  map_.image = std::make_shared<const FloorImage>(std::move(picture_), place.string(), front_.pixel_m);
  if (map_.height > 0 || front_.size) return;
  front_.size = Vec2{map_.image->wide_m(), map_.image->high_m()};
  front_.size_place = front_.picture_place;
}

void MapParser::feed(std::string_view bytes) {
  while (!bytes.empty()) {
    const void* end = std::memchr(bytes.data(), '\n', bytes.size());
    const std::size_t length =
        end ? static_cast<std::size_t>(static_cast<const char*>(end) - bytes.data()) : bytes.size();
    if (!end || !carry_.empty()) carry_.append(bytes.substr(0, length));
    if (!end) {
      if (section_ != Section::front_matter && carry_.size() > kMaxSide + std::size_t{1}) take_line(carry_);
      if (section_ == Section::front_matter) limit_front_matter(carry_.size());
      return;
    }
    take_line(carry_.empty() ? bytes.substr(0, length) : std::string_view(carry_));
    carry_.clear();
    bytes.remove_prefix(length + 1);
  }
}

void MapParser::take_line(std::string_view line) {
  ++line_;
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  switch (section_) {
    case Section::beginning:
      line = without_byte_order_mark(line);
      if (line == kFence) {
        section_ = Section::front_matter;
        return;
      }
      section_ = Section::grid;
      break;
    case Section::front_matter:
      if (line == kFence) {
        end_front_matter();
        return;
      }
      limit_front_matter(line.size());
      front_text_.append(line).push_back('\n');
      return;
    case Section::grid:
      break;
  }
  take_row(line);
}

void MapParser::limit_front_matter(std::size_t further) const {
  if (front_text_.size() + further > kMaxFrontMatter)
    throw InputError(
        {map_.file, 1, 1},
        "the front matter that begins here is too long: expected at most 1 MB; is its closing +++ missing?");
}

void MapParser::end_front_matter() {
  front_ = read_front_matter(front_text_, map_.file, 2, draw_);
  Map settings = std::move(front_.settings);
  settings.file = std::move(map_.file);
  map_ = std::move(settings);
  for (std::size_t digit = 3; digit <= 9; ++digit)
    if (const auto& means = front_.legend.digits[digit]) meaning_['0' + digit] = code_of(*means);
  map_.legend_surfaces = front_.legend.surfaces;
  section_ = Section::grid;
}

void MapParser::take_row(std::string_view row) {
  if (map_.height == 0) {
    first_row_line_ = line_;
    if (row.empty())
      throw InputError({map_.file, line_, 1},
                       "empty line: expected the map's first row; delete the line, or draw floor as `_`");
    if (row.size() > kMaxSide) {
      for (std::size_t i = 0; i < row.size(); ++i)
        if (!is_allowed(row[i])) refuse_character(row, i);
      throw InputError({map_.file, line_, kMaxSide + 1},
                       fmt::format("the row is too long: expected at most {} cells", kMaxSide));
    }
    map_.width = static_cast<int>(row.size());
    row_.resize(row.size());
    map_.cells.reserve(std::min(size_hint_, kMaxCells));
  }
  const auto width = static_cast<std::size_t>(map_.width);
  if (row.size() != width) refuse_length(row);
  if (map_.height == kMaxSide || map_.cells.size() + width > kMaxCells)
    throw InputError(
        {map_.file, line_, 1},
        fmt::format(
            "the map is too large: expected at most {} rows and {} cells, got more than {} rows of {} "
            "cells",
            kMaxSide, kMaxCells, map_.height, width));
  if (!read_plain(row, row_.data())) take_any_row(row);
  count_for_swap(row);
  map_.cells.insert(map_.cells.end(), row_.begin(), row_.end());
  ++map_.height;
}

void MapParser::take_any_row(std::string_view row) {
  std::uint8_t seen = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::uint8_t meaning = meaning_[static_cast<unsigned char>(row[i])];
    row_[i] = static_cast<Cell>(meaning & kCell);
    seen |= meaning;
  }
  if (seen < kNothing && (seen & kSurface)) take_surfaces(row);
  if (seen < kMark) return;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (!is_allowed(row[i])) refuse_character(row, i);
    const CellAt at{static_cast<int>(i), map_.height};
    if (row[i] == 'S') mark(start_mark_, at, 'S');
    if (row[i] == 'G') mark(goal_mark_, at, 'G');
  }
}

void MapParser::take_surfaces(std::string_view row) {
  map_.surface_of_cell.resize(map_.cells.size());
  for (const char c : row)
    map_.surface_of_cell.push_back((meaning_[static_cast<unsigned char>(c)] & kSurface) >> kSurfaceShift);
}

void MapParser::mark(std::optional<CellAt>& which, CellAt cell, char c) {
  if (which) {
    const Place first = place_of(*which);
    throw InputError(place_of(cell),
                     fmt::format("second `{}`: expected at most one; the first is in line {}, column {}", c,
                                 first.line, first.column));
  }
  which = cell;
}

void MapParser::count_for_swap(std::string_view row) {
  if (!has_hash_) has_hash_ = std::memchr(row.data(), '#', row.size()) != nullptr;
  if (std::memchr(row.data(), '.', row.size())) dots_ += count(row, '.');
}

void MapParser::refuse_character(std::string_view row, std::size_t column) const {
  const Place place{map_.file, line_, static_cast<int>(column) + 1};
  if (row.starts_with(kFence)) {
    if (line_ != 1)
      throw InputError(place, "unexpected +++: front matter may only begin on the first line of the file");
    const std::size_t next = row.size() > kFence.size() ? kFence.size() : 0;
    throw InputError({map_.file, line_, static_cast<int>(next) + 1},
                     fmt::format("unexpected text after +++: expected nothing else on this line, got {}",
                                 describe_character(row, next)));
  }
  std::string legend;
  for (char digit = '3'; digit <= '9'; ++digit)
    if (front_.legend.digits[static_cast<std::size_t>(digit - '0')]) legend += fmt::format(" `{}`", digit);
  std::string found = describe_character(row, column);
  if (row[column] >= '3' && row[column] <= '9') found += "; the front matter has no [legend] for it";
  throw InputError(
      place,
      fmt::format("unexpected character: expected `0`, space or `_` for floor, `1` or `.` for line, `2` or "
                  "`#` for wall, `S`, `G`, `x`{}, got {}",
                  legend.empty() ? " or a digit of a [legend]" : " or the legend's" + legend, found));
}

void MapParser::refuse_length(std::string_view row) const {
  const auto width = static_cast<std::size_t>(map_.width);
  for (std::size_t i = 0; i < std::min(row.size(), width + 1); ++i)
    if (!is_allowed(row[i])) refuse_character(row, i);
  if (row.empty())
    throw InputError(
        {map_.file, line_, 1},
        fmt::format("empty line: expected {} cells, as in the first row; were trailing spaces stripped? Use "
                    "`_`, or delete the line",
                    width));
  if (row.size() < width)
    throw InputError(
        {map_.file, line_, static_cast<int>(row.size()) + 1},
        fmt::format("the row is too short: expected {} cells, as in the first row, got {}; were trailing "
                    "spaces stripped? Use `_`",
                    width, row.size()));
  throw InputError(
      {map_.file, line_, map_.width + 1},
      fmt::format("the row is too long: expected {} cells, as in the first row, got {}; were trailing spaces "
                  "stripped from the first? Use `_`",
                  width, row.size()));
}

Map MapParser::finish() {
  if (!carry_.empty()) take_line(std::exchange(carry_, {}));
  if (line_ == 0) throw InputError({map_.file}, "the file is empty: expected at least one row of cells");
  if (section_ == Section::front_matter)
    throw InputError({map_.file, 1, 1}, "the front matter that begins here never ends: expected a line +++");
  if (!front_.picture.empty()) load_picture();
  if (map_.height == 0) make_floor();
  if (!map_.surface_of_cell.empty()) map_.surface_of_cell.resize(map_.cells.size());
  check_course();
  check_swap();
  settle_start();
  settle_stations();
  map_.differs = differs_;
  return std::move(map_);
}

// Makes an empty floor of the given size, for a map with paths and without rows.
void MapParser::make_floor() {
  if (!front_.size)
    throw InputError(
        {map_.file, line_, 1},
        map_.course.empty()
            ? "no cells follow the front matter: expected at least one row"
            : "no cells follow the front matter: expected rows, or the size of the floor, as in size = "
              "[\"3.6 m\", \"1.8 m\"]");
  const auto cells = [&](double metres) { return static_cast<int>(std::ceil(metres / map_.cell_m - 1e-9)); };
  map_.width = cells(front_.size->x);
  map_.height = cells(front_.size->y);
  const auto all = static_cast<std::size_t>(map_.width) * static_cast<std::size_t>(map_.height);
  if (all > kMaxBareCells)
    throw InputError(front_.size_place, fmt::format("size: expected at most {} cells, got {} x {}",
                                                    kMaxBareCells, map_.width, map_.height));
  map_.cells.assign(all, Cell::floor);
  front_.size.reset();
}

void MapParser::check_course() const {
  if (front_.size)
    throw InputError(front_.size_place,
                     "size requires a floor without rows; this floor is as large as its rows");
  if (map_.raster && !map_.course.empty())
    throw InputError({map_.file}, "floor = \"raster\" paints cells only, but this map has paths");
  if (map_.image) check_picture(map_, front_.picture_place);
  check_shapes(map_);
  const double wide = map_.width * map_.cell_m, high = map_.height * map_.cell_m;
  for (const Path& path : map_.course.paths)
    for (std::size_t i = 0; i < path.pieces().size(); ++i) {
      const PathPiece& piece = path.pieces()[i];
      const int steps = 1 + static_cast<int>(std::abs(piece.turn) * 20.0);
      for (int step = 0; step <= steps; ++step) {
        const Vec2 p = piece.at(piece.length * step / steps).position;
        if (p.x >= 0.0 && p.y >= 0.0 && p.x <= wide && p.y <= high) continue;
        throw InputError(
            path.place,
            fmt::format("segment {} of this path leaves the floor at {:.0f} mm, {:.0f} mm; the floor "
                        "is {:.10g} x {:.10g} mm",
                        i + 1, 1e3 * p.x, 1e3 * p.y, 1e3 * wide, 1e3 * high));
      }
    }
}

CellAt MapParser::first_cell_of(Cell kind) const {
  const auto found = std::find(map_.cells.begin(), map_.cells.end(), kind);
  return map_.cell_at(static_cast<std::size_t>(found - map_.cells.begin()));
}

void MapParser::check_swap() const {
  if (!has_hash_ || dots_ * 2 <= map_.cells.size()) return;
  throw InputError(
      place_of(first_cell_of(Cell::line)),
      fmt::format("{} of {} cells are line, written `.`, and `#` is wall: were `.` and `#` swapped? If so "
                  "much line is intended, write it as `1`",
                  dots_, map_.cells.size()));
}

void MapParser::settle_start() {
  std::optional<CellAt> cell = start_mark_;
  Place place = start_mark_ ? place_of(*start_mark_) : Place{};
  if (front_.start) {
    if (front_.start->cell && start_mark_ && *front_.start->cell != *start_mark_)
      throw InputError(front_.start->place,
                       fmt::format("[start] is column {}, row {}, but the map has an `S` in line "
                                   "{}, column {}; remove one of them",
                                   front_.start->cell->x, front_.start->cell->y, place.line, place.column));
    place = front_.start->place;
    if (front_.start->on_path) {
      if (start_mark_)
        throw InputError(place, "[start] is on a path, but the map also has an `S`; remove one of them");
      map_.start = start_on(map_, *front_.start->on_path);
      return;
    }
    if (front_.start->cell) cell = front_.start->cell;
    if (!cell)
      throw InputError(place, "[start] requires x and y (column and row from 0), because the map has no `S`");
  }
  if (!cell) return;
  require_line(map_, *cell, place, "the start");
  if (map_.at(*cell) == Cell::obstacle)
    throw InputError(place, "the start is on an obstacle; move one of them");
  const bool facing = front_.start && front_.start->facing;
  map_.start = Start{*cell, facing ? *front_.start->facing : default_facing(map_, *cell)};
}

void MapParser::settle_stations() {
  for (const auto& [station, place] : front_.stations) {
    require_line(map_, station.cell, place, "station " + station.name);
    for (const NamedStation& other : map_.stations)
      if (other.cell == station.cell)
        throw InputError(
            place, fmt::format("station {} is on the same cell as station {}", station.name, other.name));
    map_.stations.push_back(station);
  }
  map_.goal_cell = goal_mark_;
  if (front_.goal_cell) {
    const auto& [cell, place] = *front_.goal_cell;
    if (goal_mark_ && *goal_mark_ != cell)
      throw InputError(
          place, fmt::format("[goal] is column {}, row {}, but the map has a `G` in line {}, column {}; "
                             "remove one of them",
                             cell.x, cell.y, place_of(*goal_mark_).line, place_of(*goal_mark_).column));
    require_line(map_, cell, place, "the goal");
    map_.goal_cell = cell;
  }
  if (!map_.goal_cell) return;
  const Place place = front_.goal_cell ? front_.goal_cell->place : place_of(*goal_mark_);
  auto station = std::find_if(map_.stations.begin(), map_.stations.end(),
                              [&](const NamedStation& s) { return s.cell == *map_.goal_cell; });
  if (station == map_.stations.end()) {
    for (const NamedStation& other : map_.stations)
      if (other.name == "goal")
        throw InputError(place, "the goal is not on the station named goal; rename that station");
    station = map_.stations.insert(station, {"goal", *map_.goal_cell});
  }
  if (map_.goal.empty()) {
    map_.goal = "station:" + station->name;
    map_.goal_place = place;
  }
}

}  // namespace robosim::map
