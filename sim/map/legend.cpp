#include "sim/map/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "sim/base/did_you_mean.h"

namespace robosim::map {
namespace {

constexpr Cell kCells[] = {Cell::floor, Cell::line, Cell::wall, Cell::gap, Cell::obstacle};

std::optional<Cell> cell_of(std::string_view word) {
  for (const Cell cell : kCells)
    if (word == cell_word(cell)) return cell;
  return std::nullopt;
}

const SurfaceKind* kind_of(std::string_view word) {
  for (const SurfaceKind& kind : kSurfaces)
    if (word == kind.name) return &kind;
  return nullptr;
}

class Reader {
 public:
  explicit Reader(Draw draw) : draw_(draw) {}

  void read(const std::string& key, const ConfigValue& value) {
    if (key.size() != 1 || key[0] < '3' || key[0] > '9')
      throw InputError(value.place, fmt::format("[legend]: expected keys from 3 to 9, got `{}`", key));
    std::optional<Legend::Meaning>& meaning = legend_.digits[static_cast<std::size_t>(key[0] - '0')];
    meaning = value.kind == ConfigValue::Kind::table ? by_table(key, value) : by_words(key, value);
  }
  Legend take() { return std::move(legend_); }

 private:
  Legend::Meaning by_words(const std::string& key, const ConfigValue& value) {
    if (value.kind != ConfigValue::Kind::string)
      throw InputError(value.place,
                       fmt::format("{}: expected words, such as \"wet line\", or a table, such as {{ cell = "
                                   "\"line\", grip = 0.5 }}, got {}",
                                   key, to_string(value.kind)));
    const std::string& text = value.string;
    if (const std::optional<Cell> cell = cell_of(text)) return {*cell};
    const std::size_t space = std::min(text.find(' '), text.size());
    const SurfaceKind* const kind = kind_of(std::string_view(text).substr(0, space));
    const std::optional<Cell> cell =
        space == text.size() ? Cell::floor : cell_of(std::string_view(text).substr(space + 1));
    if (!kind || !cell)
      throw InputError(value.place,
                       fmt::format("{}: expected a cell (floor, line, wall, gap or obstacle), a surface of "
                                   "the floor ({}), or a surface and a cell, as in \"wet line\", got \"{}\"",
                                   key, surface_names(), text));
    return {*cell, surface({kind->grip, kind->rolling}, *cell, key, value)};
  }

  Legend::Meaning by_table(const std::string& key, const ConfigValue& value) {
    TableReader table(value, fmt::format("{} of [legend]", key));
    const ConfigValue* const word = table.find("cell");
    const std::string name = word ? as_string(*word, "cell") : "floor";
    const std::optional<Cell> cell = cell_of(name);
    if (!cell)
      throw InputError(word->place,
                       fmt::format("cell: {}", expected_one_of(name, {"floor", "line", "gap", "obstacle"})));
    const SurfaceFigures figures = read_surface_figures(table, SampledParameters(draw_, "[legend] " + key));
    table.finish();
    return {*cell, surface(figures, *cell, key, value)};
  }

  std::uint8_t surface(SurfaceFigures figures, Cell cell, const std::string& key, const ConfigValue& value) {
    if (cell == Cell::wall)
      throw InputError(value.place,
                       fmt::format("{}: a wall has no surface, because nothing drives on it: expected floor, "
                                   "line, gap or obstacle",
                                   key));
    legend_.surfaces.push_back(figures);
    return static_cast<std::uint8_t>(legend_.surfaces.size());
  }

  Draw draw_;
  Legend legend_;
};

// Returns the meaning of a digit in the format that read_legend() reads.
std::string meaning_text(Cell cell, const SurfaceFigures* surface) {
  if (!surface) return fmt::format("\"{}\"", cell_word(cell));
  for (const SurfaceKind& kind : kSurfaces)
    if (kind.grip == surface->grip && kind.rolling == surface->rolling)
      return fmt::format("\"{} {}\"", kind.name, cell_word(cell));
  return fmt::format("{{ cell = \"{}\", grip = {}, rolling = {} }}", cell_word(cell), surface->grip,
                     surface->rolling);
}

}  // namespace

const char* cell_word(Cell cell) {
  switch (cell) {
    case Cell::floor:
      return "floor";
    case Cell::line:
      return "line";
    case Cell::wall:
      return "wall";
    case Cell::gap:
      return "gap";
    case Cell::obstacle:
      return "obstacle";
  }
  return "";
}

Legend read_legend(const ConfigValue& value, Draw draw) {
  if (value.kind != ConfigValue::Kind::table)
    throw InputError(value.place,
                     fmt::format("legend: expected a table, [legend] and then lines such as 3 = \"gap\", "
                                 "got {}",
                                 to_string(value.kind)));
  Reader reader(draw);
  for (const auto& [key, meaning] : value.members) reader.read(key, meaning);
  return reader.take();
}

LegendWriter::LegendWriter(const Map& map) : digit_((map.legend_surfaces.size() + 1) * 8, '\0') {
  std::vector<bool> used(digit_.size());
  for (std::size_t i = 0; i < map.cells.size(); ++i) used[index(map.cells[i], map.surface_at(i))] = true;
  char next = '3';
  for (std::size_t surface = 0; surface <= map.legend_surfaces.size(); ++surface)
    for (const Cell cell : kCells) {
      if (!used[index(cell, surface)] || (surface == 0 && cell != Cell::gap)) continue;
      if (next > '9') throw std::invalid_argument("the map's cells need more than the digits 3 to 9");
      text_ += fmt::format("{} = {}\n", next,
                           meaning_text(cell, surface ? &map.legend_surfaces[surface - 1] : nullptr));
      digit_[index(cell, surface)] = next++;
    }
  if (!text_.empty()) text_ = "[legend]\n" + text_;
}

}  // namespace robosim::map
