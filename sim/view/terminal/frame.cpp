#include "sim/view/terminal/frame.h"

#include <algorithm>
#include <cstdlib>

#include "sim/base/utf8.h"

namespace robosim::terminal {
namespace {

constexpr char32_t kBad = U'?';

/// Returns whether a character is one column wide in every terminal: Latin to Cyrillic without combining
/// marks, punctuation, arrows, boxes, braille.
bool is_narrow(char32_t c) {
  return (c >= 0x20 && c < 0x7F) || (c >= 0xA1 && c < 0x300 && c != 0xAD) || (c >= 0x370 && c < 0x483) ||
         (c >= 0x2010 && c < 0x2028) || (c >= 0x2030 && c < 0x205F) || (c >= 0x2190 && c < 0x2300) ||
         (c >= 0x2500 && c < 0x25FD) || (c >= 0x2800 && c < 0x2900);
}

char ascii(char32_t c) {
  if (c < 0x80) return static_cast<char>(c);
  if (c == 0x2800) return ' ';
  if (c > 0x2800 && c < 0x2900) return '*';
  switch (c) {
    case U'·':
      return '.';
    case U'░':
      return '#';
    case U'×':
      return 'x';
    case U'±':
      return '~';
    case U'–':
    case U'—':
    case U'─':
      return '-';
    case U'‘':
    case U'’':
      return '\'';
    case U'“':
    case U'”':
      return '"';
    case U'→':
      return '>';
    case U'←':
      return '<';
    case U'↑':
    case U'↗':
    case U'↖':
      return '^';
    case U'↓':
    case U'↘':
    case U'↙':
      return 'v';
    default:
      break;
  }
  return c >= U'▁' && c <= U'▏' ? '=' : static_cast<char>(kBad);
}

void move_to(std::string& bytes, int column, int row) {
  bytes += "\033[" + std::to_string(row + 1) + ';' + std::to_string(column + 1) + 'H';
}

}  // namespace

Look look_from_environment(bool terminal) {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string_view(value ? value : "");
  };
  Look look{false, terminal && variable("NO_COLOR").empty() && variable("TERM") != "dumb"};
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    const std::string_view value = variable(name);
    if (value.empty()) continue;
    std::string lower;
    for (const char c : value) lower += static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
    look.utf8 = lower.find("utf-8") != std::string::npos || lower.find("utf8") != std::string::npos;
    break;
  }
  return look;
}

Frame::Frame(int columns, int rows)
    : columns_(std::max(columns, 0)),
      rows_(std::max(rows, 0)),
      glyphs_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

int Frame::put(int column, int row, std::string_view text, Ink ink) {
  for (const char32_t c : printable(text)) set(column++, row, {c, ink});
  return column;
}

std::u32string printable(std::string_view utf8) {
  std::u32string characters;
  while (!utf8.empty()) {
    const auto [code, length] = first_character(utf8);
    const char32_t c = length > 0 ? code : kBad;
    utf8.remove_prefix(std::max<std::size_t>(length, 1));
    characters += is_narrow(c) ? c : c == U'\t' ? U' ' : kBad;
  }
  return characters;
}

void append(std::string& bytes, char32_t c, bool utf8) {
  if (utf8)
    append_utf8(bytes, c);
  else
    bytes += ascii(c);
}

std::string select(Ink ink, Look look) {
  if (!look.colour) return "";
  switch (ink) {
    case Ink::plain:
      return "\033[0m";
    case Ink::faint:
      return "\033[0;2m";
    case Ink::line:
      return "\033[0;37m";
    case Ink::wall:
      return "\033[0;90m";
    case Ink::trail:
      return "\033[0;36m";
    case Ink::robot:
      return "\033[0;1;33m";
    case Ink::mark:
      return "\033[0;1;35m";
    case Ink::good:
      return "\033[0;1;32m";
    case Ink::bad:
      return "\033[0;1;31m";
    case Ink::strong:
      return "\033[0;1m";
  }
  return "";
}

std::string to_text(const Frame& frame, Look look) {
  std::string text;
  for (int row = 0; row < frame.rows(); ++row) {
    int end = frame.columns();
    while (end > 0 && (frame.at(end - 1, row).c == U' ' || frame.at(end - 1, row).c == 0x2800)) --end;
    Ink ink = Ink::plain;
    for (int column = 0; column < end; ++column) {
      const Glyph& glyph = frame.at(column, row);
      if (glyph.ink != ink && glyph.c != U' ') text += select(ink = glyph.ink, look);
      append(text, glyph.c, look.utf8);
    }
    if (ink != Ink::plain) text += select(Ink::plain, look);
    text += '\n';
  }
  return text;
}

std::string changes(const Frame& before, const Frame& after, Look look) {
  std::string bytes;
  const bool everything = before.columns() != after.columns() || before.rows() != after.rows();
  if (everything) bytes += select(Ink::plain, look) + "\033[2J";
  Ink ink = Ink::plain;
  for (int row = 0; row < after.rows(); ++row) {
    int cursor = -1;  // column after the last character written in this row
    for (int column = 0; column < after.columns(); ++column) {
      const Glyph& glyph = after.at(column, row);
      if (everything ? glyph == Glyph{} : glyph == before.at(column, row)) continue;
      if (cursor != column) move_to(bytes, column, row);
      if (glyph.ink != ink) bytes += select(ink = glyph.ink, look);
      append(bytes, glyph.c, look.utf8);
      cursor = column + 1;
    }
  }
  if (ink != Ink::plain) bytes += select(Ink::plain, look);
  return bytes;
}

}  // namespace robosim::terminal
