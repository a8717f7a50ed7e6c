#include "sim/robot/parts/hd44780.h"

namespace robosim::robot {
namespace {

constexpr SimTime kLcdBusy = 37 * kMicrosecond;
constexpr SimTime kLcdClears = 1520 * kMicrosecond;

}  // namespace

void Hd44780::write(bool is_data, std::uint8_t lines, SimTime t) {
  if (t < busy_until_) {
    ++lost_;
    return;
  }
  std::uint8_t byte = lines;
  if (!wide_) {
    half_ = !half_;
    if (half_) {
      high_ = lines & 0xF0;
      return;
    }
    byte = static_cast<std::uint8_t>(high_ | lines >> 4);
  }
  busy_until_ = t + (!is_data && byte < 4 ? kLcdClears : kLcdBusy);
  changed_at_ = t;
  if (is_data)
    put(byte);
  else
    instruct(byte);
}

// Executes an instruction. The highest set bit selects the instruction: table 6 of the data sheet.
void Hd44780::instruct(std::uint8_t code) {
  if (code & 0x80) {  // address
    in_pictures_ = false;
    const int wanted = code & 0x7F;
    const int line = two_lines_ && wanted >= 0x40 ? kLine : 0;
    address_ = (line + (two_lines_ ? wanted & 0x3F : wanted)) % (2 * kLine);
  } else if (code & 0x40) {  // address of a character's picture
    in_pictures_ = true;
  } else if (code & 0x20) {  // function set
    wide_ = code & 0x10;
    two_lines_ = code & 0x08;
    half_ = false;
  } else if (code & 0x10) {  // shift of cursor or display
    const int by = code & 0x04 ? 1 : -1;
    if (code & 0x08)
      shift_ = (shift_ - by + kLine) % kLine;
    else
      step(by);
  } else if (code & 0x08) {
    on_ = code & 0x04;
  } else if (code & 0x04) {  // entry mode
    increments_ = code & 0x02;
    shifts_ = code & 0x01;
  } else if (code & 0x03) {  // home, clear
    if (code & 0x01 && !(code & 0x02)) {
      memory_ = blank();
      increments_ = true;
    }
    address_ = shift_ = 0;
    in_pictures_ = false;
  }
}

void Hd44780::put(std::uint8_t character) {
  if (in_pictures_) return;
  memory_[static_cast<std::size_t>(address_)] = character;
  step(increments_ ? 1 : -1);
  if (shifts_) shift_ = (shift_ + (increments_ ? 1 : kLine - 1)) % kLine;
}

void Hd44780::step(int by) { address_ = (address_ + by + 2 * kLine) % (2 * kLine); }

std::string Hd44780::text(int columns, int rows) const {
  if (!on_) return "";
  std::string all;
  for (int row = 0; row < rows; ++row) {
    // On a display with four rows, rows 2 and 3 show the continuation of the memory's two lines.
    const int line = row % 2 * kLine, first = row / 2 * columns;
    std::string text;
    for (int column = 0; column < columns; ++column) {
      const std::uint8_t c = memory_[static_cast<std::size_t>(line + (first + column + shift_) % kLine)];
      text += c >= 0x20 && c < 0x7F ? static_cast<char>(c) : c == 0xDF ? '\'' : c == 0xFF ? '#' : '?';
    }
    text.erase(text.find_last_not_of(' ') + 1);
    all += (row ? "|" : "") + text;
  }
  all.erase(all.find_last_not_of('|') + 1);
  return all;
}

}  // namespace robosim::robot
