#include "sim/robot/parts/pixel_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

namespace robosim::robot {
namespace {

constexpr int kColumns = 5, kRows = 8, kAdvance = 6, kLargest = 4, kMostSpaces = 2;

/// The five columns of a letter. The leftmost column is in the highest digits; each column's lowest bit is on
/// top.
struct Glyph {
  char letter;
  std::uint64_t columns;
};

// Includes both shapes of each letter that differs between Adafruit's GFX and older tables.
constexpr Glyph kGlyphs[] = {
    {'!', 0x00005F0000}, {'"', 0x0007000700}, {'#', 0x147F147F14},  {'$', 0x242A7F2A12},  {'%', 0x2313086462},
    {'&', 0x3649562050}, {'&', 0x3649552250}, {'\'', 0x0008070300}, {'\'', 0x0005030000}, {'(', 0x001C224100},
    {')', 0x0041221C00}, {'*', 0x2A1C7F1C2A}, {'*', 0x14083E0814},  {'+', 0x08083E0808},  {',', 0x0080703000},
    {',', 0x0050300000}, {'-', 0x0808080808}, {'.', 0x0000606000},  {'.', 0x0060600000},  {'/', 0x2010080402},
    {'0', 0x3E5149453E}, {'1', 0x00427F4000}, {'2', 0x7249494946},  {'2', 0x4261514946},  {'3', 0x2141494D33},
    {'3', 0x2141454B31}, {'4', 0x1814127F10}, {'5', 0x2745454539},  {'6', 0x3C4A494931},  {'6', 0x3C4A494930},
    {'7', 0x4121110907}, {'7', 0x0171090503}, {'8', 0x3649494936},  {'9', 0x464949291E},  {'9', 0x064949291E},
    {':', 0x0000140000}, {':', 0x0036360000}, {';', 0x0040340000},  {';', 0x0056360000},  {'<', 0x0008142241},
    {'<', 0x0814224100}, {'=', 0x1414141414}, {'>', 0x0041221408},  {'>', 0x4122140800},  {'?', 0x0201590906},
    {'?', 0x0201510906}, {'@', 0x3E415D594E}, {'@', 0x324979413E},  {'A', 0x7C1211127C},  {'A', 0x7E1111117E},
    {'B', 0x7F49494936}, {'C', 0x3E41414122}, {'D', 0x7F4141413E},  {'D', 0x7F4141221C},  {'E', 0x7F49494941},
    {'F', 0x7F09090901}, {'G', 0x3E41415173}, {'G', 0x3E4149497A},  {'H', 0x7F0808087F},  {'I', 0x00417F4100},
    {'J', 0x2040413F01}, {'K', 0x7F08142241}, {'L', 0x7F40404040},  {'M', 0x7F021C027F},  {'M', 0x7F020C027F},
    {'N', 0x7F0408107F}, {'O', 0x3E4141413E}, {'P', 0x7F09090906},  {'Q', 0x3E4151215E},  {'R', 0x7F09192946},
    {'S', 0x2649494932}, {'S', 0x4649494931}, {'T', 0x03017F0103},  {'T', 0x01017F0101},  {'U', 0x3F4040403F},
    {'V', 0x1F2040201F}, {'W', 0x3F4038403F}, {'X', 0x6314081463},  {'Y', 0x0304780403},  {'Y', 0x0708700807},
    {'Z', 0x6159494D43}, {'Z', 0x6151494543}, {'[', 0x007F414141},  {'[', 0x007F414100},  {']', 0x004141417F},
    {']', 0x0041417F00}, {'_', 0x4040404040}, {'a', 0x2054547840},  {'a', 0x2054545478},  {'b', 0x7F28444438},
    {'b', 0x7F48444438}, {'c', 0x3844444428}, {'c', 0x3844444420},  {'d', 0x384444287F},  {'d', 0x384444487F},
    {'e', 0x3854545418}, {'f', 0x00087E0902}, {'f', 0x087E090102},  {'g', 0x18A4A49C78},  {'g', 0x0C5252523E},
    {'h', 0x7F08040478}, {'i', 0x00447D4000}, {'j', 0x2040403D00},  {'j', 0x2040443D00},  {'k', 0x7F10284400},
    {'k', 0x007F102844}, {'l', 0x00417F4000}, {'m', 0x7C04780478},  {'m', 0x7C04180478},  {'n', 0x7C08040478},
    {'o', 0x3844444438}, {'p', 0xFC18242418}, {'p', 0x7C14141408},  {'q', 0x18242418FC},  {'q', 0x081414187C},
    {'r', 0x7C08040408}, {'s', 0x4854545424}, {'s', 0x4854545420},  {'t', 0x04043F4424},  {'t', 0x043F444020},
    {'u', 0x3C4040207C}, {'v', 0x1C2040201C}, {'w', 0x3C4030403C},  {'x', 0x4428102844},  {'y', 0x4C9090907C},
    {'y', 0x0C5050503C}, {'z', 0x4464544C44},
};

const std::vector<Glyph>& sorted_glyphs() {
  static const std::vector<Glyph> glyphs = [] {
    std::vector<Glyph> all(std::begin(kGlyphs), std::end(kGlyphs));
    std::sort(all.begin(), all.end(), [](const Glyph& a, const Glyph& b) { return a.columns < b.columns; });
    return all;
  }();
  return glyphs;
}

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

struct Line {
  int x, y;
  std::string text;
};

class Reader {
 public:
  explicit Reader(Pixels& pixels) : pixels_(pixels) {}

  std::vector<Line> lines() {
    std::vector<Line> all;
    for (int scale = kLargest; scale > 0; --scale)
      for (int y = 0; y + (kRows - 1) * scale <= pixels_.height; ++y)
        for (int x = 0; x + kColumns * scale <= pixels_.width; ++x)
          if (auto line = line_at(x, y, scale)) {
            x = line->x + kAdvance * scale * static_cast<int>(line->text.size()) - 1;
            all.push_back(std::move(*line));
          }
    return all;
  }

 private:
  std::uint64_t column(int x, int y, int scale) const {
    std::uint64_t bits = 0;
    for (int row = 0; row < kRows; ++row)
      bits |= static_cast<std::uint64_t>(pixels_.at(x, y + row * scale)) << row;
    return bits;
  }

  /// Returns whether each dot of the letter is a square with sides of `scale` pixels.
  bool is_even(int x, int y, int scale) const {
    for (int dy = 0; dy < kRows * scale; ++dy)
      for (int dx = 0; dx < kAdvance * scale; ++dx)
        if (pixels_.at(x + dx, y + dy) != pixels_.at(x + dx / scale * scale, y + dy / scale * scale))
          return false;
    return true;
  }

  /// Returns the letter at a place, ' ' if the place is empty, or nullopt for an unknown pattern.
  std::optional<char> letter_at(int x, int y, int scale) const {
    std::uint64_t columns = 0;
    for (int i = 0; i < kColumns; ++i) columns = columns << 8 | column(x + i * scale, y, scale);
    if (column(x + kColumns * scale, y, scale) != 0 || (scale > 1 && !is_even(x, y, scale)))
      return std::nullopt;
    if (columns == 0) return ' ';
    const auto& glyphs = sorted_glyphs();
    const auto found =
        std::lower_bound(glyphs.begin(), glyphs.end(), columns,
                         [](const Glyph& glyph, std::uint64_t c) { return glyph.columns < c; });
    if (found == glyphs.end() || found->columns != columns) return std::nullopt;
    return found->letter;
  }

  std::optional<Line> line_at(int x, int y, int scale) {
    if (column(x, y, scale) == 0 && column(x + scale, y, scale) == 0) return std::nullopt;
    if (column(x - 1, y, scale) != 0) return std::nullopt;
    const auto first = letter_at(x, y, scale);
    if (!first || !is_letter(*first)) return std::nullopt;
    Line line{x, y, ""};
    int spaces = 0;
    for (int at = x; at + kColumns * scale <= pixels_.width; at += kAdvance * scale) {
      const auto letter = letter_at(at, y, scale);
      if (!letter || (*letter == ' ' && ++spaces > kMostSpaces)) break;
      if (*letter == ' ') continue;
      line.text += std::string(static_cast<std::size_t>(spaces), ' ') + *letter;
      spaces = 0;
    }
    if (std::count_if(line.text.begin(), line.text.end(), is_letter) < 2) return std::nullopt;
    for (int at = x - kAdvance * scale; at >= 0; at -= kAdvance * scale) {  // extends "12" to "-12"
      const auto letter = letter_at(at, y, scale);
      if (!letter || *letter == ' ') break;
      line.text.insert(line.text.begin(), *letter);
      line.x = at;
    }
    wipe(line, scale);
    return line;
  }

  // Clears recognised text, so that it is not read again as smaller letters.
  void wipe(const Line& line, int scale) {
    const int right = std::min(line.x + kAdvance * scale * static_cast<int>(line.text.size()), pixels_.width);
    for (int y = line.y; y < std::min(line.y + kRows * scale, pixels_.height); ++y)
      for (int x = line.x; x < right; ++x) pixels_.lit[static_cast<std::size_t>(y * pixels_.width + x)] = 0;
  }

  Pixels& pixels_;
};

}  // namespace

std::string text_in(Pixels pixels) {
  std::vector<Line> lines = Reader(pixels).lines();
  std::sort(lines.begin(), lines.end(),
            [](const Line& a, const Line& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
  std::string text;
  for (const Line& line : lines) text += (text.empty() ? "" : "|") + line.text;
  return text;
}

}  // namespace robosim::robot
