#include "hal/board/board_spec.h"

namespace robosim {
namespace {

constexpr PinSpec kNanoPins[] = {
    {"D0", "PD0", -1, false, -1, true},  {"D1", "PD1", -1, false, -1, true},
    {"D2", "PD2", -1, false, 0, true},   {"D3", "PD3", -1, true, 1, true},
    {"D4", "PD4", -1, false, -1, true},  {"D5", "PD5", -1, true, -1, true},
    {"D6", "PD6", -1, true, -1, true},   {"D7", "PD7", -1, false, -1, true},
    {"D8", "PB0", -1, false, -1, true},  {"D9", "PB1", -1, true, -1, true},
    {"D10", "PB2", -1, true, -1, true},  {"D11", "PB3", -1, true, -1, true},
    {"D12", "PB4", -1, false, -1, true}, {"D13", "PB5", -1, false, -1, true},
    {"A0", "PC0", 0, false, -1, true},   {"A1", "PC1", 1, false, -1, true},
    {"A2", "PC2", 2, false, -1, true},   {"A3", "PC3", 3, false, -1, true},
    {"A4", "PC4", 4, false, -1, true},   {"A5", "PC5", 5, false, -1, true},
    {"A6", "ADC6", 6, false, -1, false}, {"A7", "ADC7", 7, false, -1, false},
};

// The Uno is the same chip in a package without ADC6 and ADC7. The Blue Pill is added with its executor.
constexpr BoardSpec kBoards[] = {
    {"uno", "arduino:avr:uno", "ARDUINO_AVR_UNO", 20, kNanoPins, 14, 5.0, 1024, 16000000, 32256, 2048, 1024,
     13},
    {"nano", "arduino:avr:nano", "ARDUINO_AVR_NANO", 22, kNanoPins, 14, 5.0, 1024, 16000000, 30720, 2048,
     1024, 13},
};

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

bool same(const char* a, const char* b) {
  for (; *a && *b; ++a, ++b)
    if (upper(*a) != upper(*b)) return false;
  return *a == *b;
}

}  // namespace

const BoardSpec* board_at(int number) {
  constexpr int count = sizeof kBoards / sizeof *kBoards;
  return number >= 0 && number < count ? &kBoards[number] : nullptr;
}

const BoardSpec* find_board(const char* name) {
  for (const BoardSpec& board : kBoards)
    if (same(board.name, name)) return &board;
  return nullptr;
}

Pin find_pin(const BoardSpec& board, const char* name) {
  for (Pin pin = 0; pin < board.pin_count; ++pin) {
    const PinSpec& spec = board.pins[pin];
    const bool bare_number = spec.name[0] == 'D' && same(spec.name + 1, name);
    if (bare_number || same(spec.name, name) || same(spec.chip_name, name)) return pin;
  }
  int number = 0;
  const char* c = name;
  for (; *c >= '0' && *c <= '9' && number < kMaxPins; ++c) number = number * 10 + (*c - '0');
  return c != name && !*c && number < board.pin_count ? static_cast<Pin>(number) : kNoPin;
}

}  // namespace robosim
