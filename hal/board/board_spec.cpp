#include "hal/board/board_spec.h"

#include "hal/board/atmega168.h"
#include "hal/board/atmega2560.h"
#include "hal/board/atmega328p.h"
#include "hal/board/atmega32u4.h"
#include "hal/board/attiny85.h"
#include "hal/board/stm32f103c8.h"

namespace robosim {
namespace {

constexpr bool equal(const char* a, const char* b) {
  while (*a && *a == *b) ++a, ++b;
  return *a == *b;
}

/// An entry of a board's table of pins.
struct PinEntry {
  const char* name;
  const char* chip_name;
  int8_t interrupt;  ///< interrupt number for attachInterrupt; -1 = none
};

template <int kCount>
struct PinTable {
  PinSpec pins[kCount];
  static constexpr uint8_t kSize = kCount;
};

/// Builds a board's table of pins. An entry with an unknown chip pin causes a compile error. `core_timer` is
/// the index of a timer that the core reserves, so the pins of that timer have no PWM.
template <int kCount>
constexpr PinTable<kCount> pins_of(const ChipSpec& chip, const PinEntry (&entries)[kCount],
                                   int core_timer = -1) {
  PinTable<kCount> table{};
  for (int i = 0; i < kCount; ++i) {
    const ChipPin* pin = chip.pins;
    while (!equal(pin->name, entries[i].chip_name)) ++pin;
    int first = 0;  // if a pin has several numbers, only the lowest has PWM, as in Arduino
    while (!equal(entries[first].chip_name, entries[i].chip_name)) ++first;
    table.pins[i] = {entries[i].name,
                     entries[i].chip_name,
                     pin->analog_channel,
                     pin->timer >= 0 && pin->timer != core_timer && first == i,
                     entries[i].interrupt,
                     pin->port >= 0,
                     *pin};
  }
  return table;
}

// Source: variants/eightanaloginputs/pins_arduino.h. The Uno uses only the first 20 entries, because its
// chip's package does not have ADC6 and ADC7.
constexpr PinEntry kNanoEntries[] = {
    {"D0", "PD0", -1},  {"D1", "PD1", -1},  {"D2", "PD2", 0},   {"D3", "PD3", 1},   {"D4", "PD4", -1},
    {"D5", "PD5", -1},  {"D6", "PD6", -1},  {"D7", "PD7", -1},  {"D8", "PB0", -1},  {"D9", "PB1", -1},
    {"D10", "PB2", -1}, {"D11", "PB3", -1}, {"D12", "PB4", -1}, {"D13", "PB5", -1}, {"A0", "PC0", -1},
    {"A1", "PC1", -1},  {"A2", "PC2", -1},  {"A3", "PC3", -1},  {"A4", "PC4", -1},  {"A5", "PC5", -1},
    {"A6", "ADC6", -1}, {"A7", "ADC7", -1},
};
constexpr auto kNanoPins = pins_of(kAtmega328p, kNanoEntries);
constexpr uint8_t kUnoPinCount = 20;

// Source: variants/mega/pins_arduino.h
constexpr PinEntry kMegaEntries[] = {
    {"D0", "PE0", -1},  {"D1", "PE1", -1},  {"D2", "PE4", 0},   {"D3", "PE5", 1},   {"D4", "PG5", -1},
    {"D5", "PE3", -1},  {"D6", "PH3", -1},  {"D7", "PH4", -1},  {"D8", "PH5", -1},  {"D9", "PH6", -1},
    {"D10", "PB4", -1}, {"D11", "PB5", -1}, {"D12", "PB6", -1}, {"D13", "PB7", -1}, {"D14", "PJ1", -1},
    {"D15", "PJ0", -1}, {"D16", "PH1", -1}, {"D17", "PH0", -1}, {"D18", "PD3", 5},  {"D19", "PD2", 4},
    {"D20", "PD1", 3},  {"D21", "PD0", 2},  {"D22", "PA0", -1}, {"D23", "PA1", -1}, {"D24", "PA2", -1},
    {"D25", "PA3", -1}, {"D26", "PA4", -1}, {"D27", "PA5", -1}, {"D28", "PA6", -1}, {"D29", "PA7", -1},
    {"D30", "PC7", -1}, {"D31", "PC6", -1}, {"D32", "PC5", -1}, {"D33", "PC4", -1}, {"D34", "PC3", -1},
    {"D35", "PC2", -1}, {"D36", "PC1", -1}, {"D37", "PC0", -1}, {"D38", "PD7", -1}, {"D39", "PG2", -1},
    {"D40", "PG1", -1}, {"D41", "PG0", -1}, {"D42", "PL7", -1}, {"D43", "PL6", -1}, {"D44", "PL5", -1},
    {"D45", "PL4", -1}, {"D46", "PL3", -1}, {"D47", "PL2", -1}, {"D48", "PL1", -1}, {"D49", "PL0", -1},
    {"D50", "PB3", -1}, {"D51", "PB2", -1}, {"D52", "PB1", -1}, {"D53", "PB0", -1}, {"A0", "PF0", -1},
    {"A1", "PF1", -1},  {"A2", "PF2", -1},  {"A3", "PF3", -1},  {"A4", "PF4", -1},  {"A5", "PF5", -1},
    {"A6", "PF6", -1},  {"A7", "PF7", -1},  {"A8", "PK0", -1},  {"A9", "PK1", -1},  {"A10", "PK2", -1},
    {"A11", "PK3", -1}, {"A12", "PK4", -1}, {"A13", "PK5", -1}, {"A14", "PK6", -1}, {"A15", "PK7", -1}};
constexpr auto kMegaPins = pins_of(kAtmega2560, kMegaEntries);

// Source: variants/leonardo/pins_arduino.h. A6 to A11 are second names of the pins 4, 6, 8, 9, 10 and 12. D17
// and D30 are the LEDs RX and TX.
constexpr PinEntry kLeonardoEntries[] = {
    {"D0", "PD2", 2},   {"D1", "PD3", 3},   {"D2", "PD1", 1},   {"D3", "PD0", 0},   {"D4", "PD4", -1},
    {"D5", "PC6", -1},  {"D6", "PD7", -1},  {"D7", "PE6", 4},   {"D8", "PB4", -1},  {"D9", "PB5", -1},
    {"D10", "PB6", -1}, {"D11", "PB7", -1}, {"D12", "PD6", -1}, {"D13", "PC7", -1}, {"D14", "PB3", -1},
    {"D15", "PB1", -1}, {"D16", "PB2", -1}, {"D17", "PB0", -1}, {"A0", "PF7", -1},  {"A1", "PF6", -1},
    {"A2", "PF5", -1},  {"A3", "PF4", -1},  {"A4", "PF1", -1},  {"A5", "PF0", -1},  {"A6", "PD4", -1},
    {"A7", "PD7", -1},  {"A8", "PB4", -1},  {"A9", "PB5", -1},  {"A10", "PB6", -1}, {"A11", "PD6", -1},
    {"D30", "PD5", -1}};
constexpr auto kLeonardoPins = pins_of(kAtmega32u4, kLeonardoEntries);

// Source: variants/gemma/pins_arduino.h. A0 to A3 are second names of the pins 5, 2, 4 and 3. By default, pin
// 5 is the reset input; a fuse makes it an ordinary pin.
constexpr PinEntry kTinyEntries[] = {
    {"D0", "PB0", -1}, {"D1", "PB1", -1}, {"D2", "PB2", 0},  {"D3", "PB3", -1}, {"D4", "PB4", -1},
    {"D5", "PB5", -1}, {"A0", "PB5", -1}, {"A1", "PB2", -1}, {"A2", "PB4", -1}, {"A3", "PB3", -1}};
constexpr auto kTinyPins = pins_of(kAttiny85, kTinyEntries);

// Pins of the STM32F103C8. Numbers 0 to 19 have the functions of an Uno's pins: 0 and 1 are USART1, PWM is on
// 3, 5, 6, 9, 10 and 11, and A0 to A5 are analog. Among the pins 0 to 8, no two pins share an interrupt line.
// The remaining pins of the chip follow. Pins of TIM2 have no PWM, because the core uses TIM2 to end a sleep
// (hal/stm32/clock.h).
constexpr PinEntry kBluePillEntries[] = {
    {"D0", "PA10", 0},   {"D1", "PA9", 1},    {"D2", "PB12", 2},  {"D3", "PA8", 3},    {"D4", "PB13", 4},
    {"D5", "PB6", 5},    {"D6", "PB7", 6},    {"D7", "PB14", 7},  {"D8", "PB15", 8},   {"D9", "PB8", 9},
    {"D10", "PB9", 10},  {"D11", "PA7", 11},  {"D12", "PA6", 12}, {"D13", "PC13", 13}, {"A0", "PA0", 14},
    {"A1", "PA1", 15},   {"A2", "PA2", 16},   {"A3", "PA3", 17},  {"A4", "PA4", 18},   {"A5", "PA5", 19},
    {"A6", "PB0", 20},   {"A7", "PB1", 21},   {"D22", "PB5", 22}, {"D23", "PB10", 23}, {"D24", "PB11", 24},
    {"D25", "PA15", 25}, {"D26", "PB3", 26},  {"D27", "PB4", 27}, {"D28", "PA11", 28}, {"D29", "PA12", 29},
    {"D30", "PC14", 30}, {"D31", "PC15", 31},
};
constexpr auto kBluePillPins = pins_of(kStm32f103c8, kBluePillEntries, stm32f103c8::kTim2);

// Sources of all boards: the genuine core's boards.txt and the boards' circuit diagrams. The Uno has a diode
// (0.7 V) before its NCP1117 regulator (1.1 V). The chip's fuses make it stay in reset below 2.7 V (BODLEVEL
// 101).
constexpr BoardSpec kUno = {
    .name = "uno",
    .fqbn = "arduino:avr:uno",
    .platformio = "uno",
    .macro = "ARDUINO_AVR_UNO",
    .chip = &kAtmega328p,
    .pins = kNanoPins.pins,
    .pin_count = kUnoPinCount,
    .analog_pin_0 = 14,
    .led_builtin = 13,
    .supply_volts = 5.0,
    .clock_hz = 16000000,
    .adc_steps = 1024,
    .flash_bytes = 32256,
    .ram_bytes = kAtmega328p.ram_bytes,
    .eeprom_bytes = kAtmega328p.eeprom_bytes,
    .regulator_drop_volts = 1.8,
    .brown_out_volts = 2.7,
    .host_model = nullptr,
    .variant = "standard",
    .pin_names = nullptr,
    .upload_protocol = "arduino",
    .upload_baud = 115200,
    .upload_baud_old = 0,
};

// The Nano: an Uno with ADC6 and ADC7, and space for the larger boot loader of older Nanos.
constexpr BoardSpec nano() {
  BoardSpec board = kUno;
  board.name = "nano";
  board.fqbn = "arduino:avr:nano";
  board.platformio = "nanoatmega328new nanoatmega328";
  board.macro = "ARDUINO_AVR_NANO";
  board.pin_count = kNanoPins.kSize;
  board.flash_bytes = 30720;
  board.variant = "eightanaloginputs";
  board.upload_baud_old = 57600;
  return board;
}

// The Nano before 2010: half the memory, and a boot loader with a lower baud rate.
constexpr BoardSpec nano168() {
  BoardSpec board = nano();
  board.name = "nano168";
  board.fqbn = "arduino:avr:nano:cpu=atmega168";
  board.platformio = "nanoatmega168";
  board.chip = &kAtmega168;
  board.flash_bytes = 14336;
  board.ram_bytes = kAtmega168.ram_bytes;
  board.eeprom_bytes = kAtmega168.eeprom_bytes;
  board.upload_baud = 19200;
  board.upload_baud_old = 0;
  return board;
}

// The Pro Mini: a Nano without USB, in two variants of clock and voltage. Its regulator is a MIC5205
// (0.17 V), without a diode.
constexpr BoardSpec pro_mini(const char* name, const char* fqbn, const char* platformio, uint32_t clock_hz,
                             double supply_volts) {
  BoardSpec board = nano();
  board.name = name;
  board.fqbn = fqbn;
  board.platformio = platformio;
  board.macro = "ARDUINO_AVR_PRO";
  board.supply_volts = supply_volts;
  board.clock_hz = clock_hz;
  board.regulator_drop_volts = 0.17;
  board.upload_baud = 57600;
  board.upload_baud_old = 0;
  return board;
}

// The Mega 2560: its boot loader is an stk500v2, which avrdude calls `wiring`.
constexpr BoardSpec mega() {
  BoardSpec board = kUno;
  board.name = "mega";
  board.fqbn = "arduino:avr:mega";
  board.platformio = "megaatmega2560";
  board.macro = "ARDUINO_AVR_MEGA2560";
  board.chip = &kAtmega2560;
  board.pins = kMegaPins.pins;
  board.pin_count = kMegaPins.kSize;
  board.analog_pin_0 = 54;
  board.flash_bytes = 253952;
  board.ram_bytes = kAtmega2560.ram_bytes;
  board.eeprom_bytes = kAtmega2560.eeprom_bytes;
  board.host_model = &kUno;
  board.variant = "mega";
  board.upload_protocol = "wiring";
  return board;
}

// The Leonardo, and the Micro, which is a smaller Leonardo. Serial is the USB port, Serial1 the UART.
constexpr BoardSpec leonardo(const char* name, const char* fqbn, const char* platformio, const char* macro,
                             const char* variant, const char* usb_product, uint16_t usb_id) {
  BoardSpec board = kUno;
  board.name = name;
  board.fqbn = fqbn;
  board.platformio = platformio;
  board.macro = macro;
  board.chip = &kAtmega32u4;
  board.pins = kLeonardoPins.pins;
  board.pin_count = kLeonardoPins.kSize;
  board.analog_pin_0 = 18;
  board.flash_bytes = 28672;
  board.ram_bytes = kAtmega32u4.ram_bytes;
  board.eeprom_bytes = kAtmega32u4.eeprom_bytes;
  board.host_model = &kUno;
  board.variant = variant;
  board.upload_protocol = "avr109";
  board.upload_baud = 57600;
  board.upload_by_touch = true;
  board.serial_line = kAtmega32u4.uart_count;
  board.usb_product = usb_product;
  board.usb_id = usb_id;
  return board;
}

// Boards with an ATtiny85. avrdude cannot write to these boards by a serial port. They have no boot loader,
// or a boot loader without a serial port. A fuse sets the chip's reset threshold of 2.7 V, as on the other
// boards.
constexpr BoardSpec attiny85(const char* name, const char* fqbn, const char* platformio, const char* macro,
                             uint32_t clock_hz, double supply_volts, uint32_t flash_bytes) {
  BoardSpec board = kUno;
  board.name = name;
  board.fqbn = fqbn;
  board.platformio = platformio;
  board.macro = macro;
  board.chip = &kAttiny85;
  board.pins = kTinyPins.pins;
  board.pin_count = kTinyPins.kSize;
  board.analog_pin_0 = 6;
  board.led_builtin = 1;
  board.supply_volts = supply_volts;
  board.clock_hz = clock_hz;
  board.flash_bytes = flash_bytes;
  board.ram_bytes = kAttiny85.ram_bytes;
  board.eeprom_bytes = kAttiny85.eeprom_bytes;
  board.regulator_drop_volts = 0.17;
  board.host_model = &kUno;
  board.variant = "gemma";
  board.upload_protocol = nullptr;
  board.upload_baud = 0;
  return board;
}

// The Blue Pill, at 72 MHz with its crystal, or at 8 MHz as after a reset. The last 4 KB of flash store the
// emulated EEPROM. The regulator's voltage drop is assumed to equal the Uno's. Instead of a brown-out
// detector, the chip has a power-down reset at 1.88 V (1.80 to 1.96 V; DS5319, embedded reset and power
// control block, V POR/PDR).
constexpr BoardSpec blue_pill(const char* name, uint32_t clock_hz) {
  return {
      .name = name,
      .fqbn = "STMicroelectronics:stm32:GenF1:pnum=BLUEPILL_F103C8",
      .platformio = "bluepill_f103c8",
      .macro = "ARDUINO_BLUEPILL_F103C8",
      .chip = &kStm32f103c8,
      .pins = kBluePillPins.pins,
      .pin_count = kBluePillPins.kSize,
      .analog_pin_0 = 14,
      .led_builtin = 13,
      .supply_volts = 3.3,
      .clock_hz = clock_hz,
      .adc_steps = 1024,
      .flash_bytes = kStm32f103c8.flash_bytes,
      .ram_bytes = kStm32f103c8.ram_bytes,
      .eeprom_bytes = 1024,
      .regulator_drop_volts = kUno.regulator_drop_volts,
      .brown_out_volts = 1.88,
      .host_model = &kUno,
      .variant = nullptr,
      .pin_names = "bluepill.h",
      .upload_protocol = nullptr,
      .upload_baud = 0,
      .upload_baud_old = 0,
  };
}

// The first board of each target is the target's default. If several boards share an FQBN, the first of them
// is the board that Arduino selects without options.
constexpr BoardSpec kBoards[] = {
    kUno,
    nano(),
    nano168(),
    pro_mini("promini16", "arduino:avr:pro:cpu=16MHzatmega328", "pro16MHzatmega328", 16000000, 5.0),
    pro_mini("promini8", "arduino:avr:pro:cpu=8MHzatmega328", "pro8MHzatmega328", 8000000, 3.3),
    mega(),
    leonardo("leonardo", "arduino:avr:leonardo", "leonardo", "ARDUINO_AVR_LEONARDO", "leonardo",
             "Arduino Leonardo", 0x8036),
    leonardo("micro", "arduino:avr:micro", "micro", "ARDUINO_AVR_MICRO", "micro", "Arduino Micro", 0x8037),
    attiny85("digispark", "digistump:avr:digispark-tiny", "digispark-tiny", "ARDUINO_AVR_DIGISPARK", 16500000,
             5.0, 6012),
    attiny85("gemma", "arduino:avr:gemma", "gemma", "ARDUINO_AVR_GEMMA", 8000000, 3.3, 5310),
    attiny85("attiny85", "ATTinyCore:avr:attinyx5:chip=85,clock=8internal", "attiny85",
             "ARDUINO_AVR_ATTINYX5", 8000000, 5.0, 8192),
    blue_pill("bluepill", 72000000),
    blue_pill("bluepill8", 8000000),
};

constexpr bool pins_have_numbers() {
  for (const BoardSpec& board : kBoards)
    if (board.pin_count > kMaxPins) return false;
  return true;
}
static_assert(pins_have_numbers(), "a board has more pins than wires have numbers");

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
    if (bare_number || same(spec.name, name) || same(spec.chip_name, name)) return first_number(board, pin);
  }
  int number = 0;
  const char* c = name;
  for (; *c >= '0' && *c <= '9' && number < board.pin_count; ++c) number = number * 10 + (*c - '0');
  return c != name && !*c && number < board.pin_count ? first_number(board, static_cast<Pin>(number))
                                                      : kNoPin;
}

Pin last_digital_pin(const BoardSpec& board) {
  Pin last = 0;
  for (Pin pin = 0; pin < board.pin_count; ++pin)
    if (board.pins[pin].digital) last = pin;
  return last;
}

}  // namespace robosim
