// Parses the text of a map file, fed in pieces of any size, into a Map. Used by read_map() and parse_map().
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/map/front_matter.h"
#include "sim/map/map.h"

namespace robosim::map {

class MapParser {
 public:
  /// `size_hint` is the number of bytes to be fed, if known; the parser reserves memory accordingly.
  /// `picture` contains the bytes of the floor's picture; "" = read the picture from the file's folder.
  MapParser(std::string file, std::size_t size_hint, std::string picture = "", Draw draw = {});
  MapParser(const MapParser&) = delete;
  MapParser& operator=(const MapParser&) = delete;

  static constexpr std::size_t kMaxFrontMatter = 1 << 20;  ///< bytes
  /// Returns the name of the front matter's picture; "" = none. `beginning` is the beginning of the map's
  /// text.
  static std::string picture_named_in(std::string_view beginning, const std::string& file);

  /// Parses bytes. Throws InputError at the first error.
  void feed(std::string_view bytes);
  /// Returns the map, after all bytes are fed. Throws InputError.
  Map finish();

 private:
  static constexpr std::uint8_t kCell = 0x07, kSurface = 0x38, kMark = 0x40;
  static constexpr int kSurfaceShift = 3;
  static std::uint8_t code_of(const Legend::Meaning& means) {
    return static_cast<std::uint8_t>(static_cast<unsigned>(means.cell) | unsigned{means.surface}
                                                                             << kSurfaceShift);
  }
  static constexpr std::uint8_t kNothing = 0x80;

  enum class Section { beginning, front_matter, grid };

  void take_line(std::string_view line);
  void limit_front_matter(std::size_t further) const;
  void end_front_matter();
  void take_row(std::string_view row);
  /// Reads a row in which some character means something other than floor, line or wall.
  void take_any_row(std::string_view row);
  /// Reads the surfaces of a row. Gives earlier rows without surfaces the usual floor.
  void take_surfaces(std::string_view row);
  void mark(std::optional<CellAt>& which, CellAt cell, char c);
  void count_for_swap(std::string_view row);
  [[noreturn]] void refuse_character(std::string_view row, std::size_t column) const;
  [[noreturn]] void refuse_length(std::string_view row) const;
  void load_picture();
  void make_floor();
  void check_course() const;
  void check_swap() const;
  void settle_start();
  void settle_stations();
  bool is_allowed(char c) const { return meaning_[static_cast<unsigned char>(c)] != kNothing; }
  Place place_of(CellAt cell) const { return {map_.file, first_row_line_ + cell.y, cell.x + 1}; }
  CellAt first_cell_of(Cell kind) const;

  Map map_;
  FrontMatter front_;
  std::size_t size_hint_;
  std::array<std::uint8_t, 256>
      meaning_;  // by character: a Cell, its surface, and kMark for S and G; or kNothing
  Section section_ = Section::beginning;
  int line_ = 0;            // number of the last line read
  int first_row_line_ = 0;  // line number of row 0
  std::string picture_;     // bytes of the picture's file
  Draw draw_;
  bool differs_ = false;
  std::string carry_;  // beginning of a line whose end has not been fed yet
  std::string front_text_;
  std::vector<Cell> row_;
  std::optional<CellAt> start_mark_;
  std::optional<CellAt> goal_mark_;
  std::size_t dots_ = 0;   // number of cells written `.`
  bool has_hash_ = false;  // some cell is written `#`
};

}  // namespace robosim::map
