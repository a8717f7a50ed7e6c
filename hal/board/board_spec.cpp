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

// The STM32F103C8 has Arduino's pins 0 to 19 where they can do what an Uno's do: 0 and 1 are USART1, PWM is
// on 3, 5, 6, 9, 10 and 11, A0 to A5 are analog, and no two of 0 to 8 share an interrupt line. Then what is
// left.
constexpr PinSpec kBluePillPins[] = {
    {"D0", "PA10", -1, true, 0, true},    {"D1", "PA9", -1, true, 1, true},
    {"D2", "PB12", -1, false, 2, true},   {"D3", "PA8", -1, true, 3, true},
    {"D4", "PB13", -1, false, 4, true},   {"D5", "PB6", -1, true, 5, true},
    {"D6", "PB7", -1, true, 6, true},     {"D7", "PB14", -1, false, 7, true},
    {"D8", "PB15", -1, false, 8, true},   {"D9", "PB8", -1, true, 9, true},
    {"D10", "PB9", -1, true, 10, true},   {"D11", "PA7", 7, true, 11, true},
    {"D12", "PA6", 6, true, 12, true},    {"D13", "PC13", -1, false, 13, true},
    {"A0", "PA0", 0, false, 14, true},    {"A1", "PA1", 1, false, 15, true},
    {"A2", "PA2", 2, false, 16, true},    {"A3", "PA3", 3, false, 17, true},
    {"A4", "PA4", 4, false, 18, true},    {"A5", "PA5", 5, false, 19, true},
    {"A6", "PB0", 8, true, 20, true},     {"A7", "PB1", 9, true, 21, true},
    {"D22", "PB5", -1, false, 22, true},  {"D23", "PB10", -1, false, 23, true},
    {"D24", "PB11", -1, false, 24, true}, {"D25", "PA15", -1, false, 25, true},
    {"D26", "PB3", -1, false, 26, true},  {"D27", "PB4", -1, false, 27, true},
    {"D28", "PA11", -1, true, 28, true},  {"D29", "PA12", -1, false, 29, true},
    {"D30", "PC14", -1, false, 30, true}, {"D31", "PC15", -1, false, 31, true},
};

// The Uno is the Nano's chip in a package without ADC6 and ADC7. Two of the Blue Pill: at 72 MHz by its
// crystal, and at 8 MHz as it comes from a reset. The last 4 KB of its flash are the EEPROM's.
constexpr BoardSpec kBoards[] = {
    {"uno", "arduino:avr:uno", "ARDUINO_AVR_UNO", 20, kNanoPins, 14, 5.0, 1024, 16000000, 32256, 2048, 1024,
     13},
    {"nano", "arduino:avr:nano", "ARDUINO_AVR_NANO", 22, kNanoPins, 14, 5.0, 1024, 16000000, 30720, 2048,
     1024, 13},
    {"bluepill", "STMicroelectronics:stm32:GenF1:pnum=BLUEPILL_F103C8", "ARDUINO_BLUEPILL_F103C8", 32,
     kBluePillPins, 14, 3.3, 1024, 72000000, 61440, 20480, 1024, 13},
    {"bluepill8", "STMicroelectronics:stm32:GenF1:pnum=BLUEPILL_F103C8", "ARDUINO_BLUEPILL_F103C8", 32,
     kBluePillPins, 14, 3.3, 1024, 8000000, 61440, 20480, 1024, 13},
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
