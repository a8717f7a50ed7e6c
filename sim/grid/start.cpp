// Where a robot begins.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>

#include "sim/grid/front_matter.h"
#include "sim/grid/map.h"

namespace robosim::grid {
namespace {

// "12" at the front of text, taken off it.
std::optional<int> take_number(std::string_view& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || number < 0) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

bool take_comma(std::string_view& text) {
  if (!text.starts_with(',')) return false;
  text.remove_prefix(1);
  return true;
}

std::optional<Direction> direction_of(std::string_view text) {
  if (text.size() != 1) return std::nullopt;
  const char c = text[0] >= 'a' && text[0] <= 'z' ? static_cast<char>(text[0] - 'a' + 'A') : text[0];
  const auto found = std::string_view("ESWN").find(c);
  if (found == std::string_view::npos) return std::nullopt;
  return static_cast<Direction>(found);
}

}  // namespace

Direction default_facing(const Map& map, CellAt cell) {
  const unsigned lines = line_neighbours(map, cell);
  return lines ? static_cast<Direction>(std::countr_zero(lines)) : Direction::east;
}

Start parse_start(const Map& map, std::string_view text) {
  const InputError malformed(
      fmt::format("the start is \"{}\"; it must be COLUMN,ROW,DIRECTION such as 13,2,E (the "
                  "direction, one of E, S, W or N, may be left out)",
                  text));
  std::string_view rest = text;
  const auto x = take_number(rest);
  if (!x || !take_comma(rest)) throw malformed;
  const auto y = take_number(rest);
  if (!y) throw malformed;
  std::optional<Direction> facing;
  if (!rest.empty()) {
    if (!take_comma(rest) || !(facing = direction_of(rest))) throw malformed;
  }
  const CellAt cell{*x, *y};
  require_line(map, cell, {}, fmt::format("the start \"{}\"", text));
  if (map.at(cell) == Cell::obstacle)
    throw InputError(fmt::format("the start \"{}\" is a cell with an obstacle", text));
  return {cell, facing ? *facing : default_facing(map, cell)};
}

Start default_start(const Map& map) {
  if (map.start) return *map.start;
  std::optional<CellAt> first;
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    if (!is_line(map.cells[i]) || map.cells[i] == Cell::obstacle) continue;
    const CellAt cell = map.cell_at(i);
    if (line_neighbours(map, cell) != 0 && is_dead_end(map, cell)) return {cell, default_facing(map, cell)};
    if (!first) first = cell;
  }
  if (!first) throw InputError({map.file}, "the map has no line on which a robot could start");
  return {*first, default_facing(map, *first)};
}

}  // namespace robosim::grid
