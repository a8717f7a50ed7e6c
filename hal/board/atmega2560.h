// Describes the ATmega2560 of an Arduino Mega 2560. Source: data sheet 2549Q; comments give section numbers.
//
// On the chip, PB7 is the output OC0A of timer 0 and the output OC1C of timer 1. In this table PB7 is only
// OC0A, as in Arduino's core.
#pragma once

#include "hal/board/chip_spec.h"

namespace robosim {
namespace atmega2560 {

// 33: the register summary
constexpr PortSpec kPorts[] = {{'A', 0x20},  {'B', 0x23},  {'C', 0x26}, {'D', 0x29},
                               {'E', 0x2C},  {'F', 0x2F},  {'G', 0x32}, {'H', 0x100},
                               {'J', 0x103}, {'K', 0x106}, {'L', 0x109}};
constexpr int8_t kA = 0, kB = 1, kC = 2, kD = 3, kE = 4, kF = 5, kG = 6, kH = 7, kJ = 8, kK = 9, kL = 10;

// 1 and 13.3: the pins. Timers are given by their index in kTimers.
constexpr ChipPin kPins[] = {
    // name, port, bit, ADC, timer, output, INT, PCINT, T, ICP
    {"PA0", kA, 0, -1, -1, 0, -1, -1, -1, -1}, {"PA1", kA, 1, -1, -1, 0, -1, -1, -1, -1},
    {"PA2", kA, 2, -1, -1, 0, -1, -1, -1, -1}, {"PA3", kA, 3, -1, -1, 0, -1, -1, -1, -1},
    {"PA4", kA, 4, -1, -1, 0, -1, -1, -1, -1}, {"PA5", kA, 5, -1, -1, 0, -1, -1, -1, -1},
    {"PA6", kA, 6, -1, -1, 0, -1, -1, -1, -1}, {"PA7", kA, 7, -1, -1, 0, -1, -1, -1, -1},
    {"PB0", kB, 0, -1, -1, 0, -1, 0, -1, -1},  {"PB1", kB, 1, -1, -1, 0, -1, 1, -1, -1},
    {"PB2", kB, 2, -1, -1, 0, -1, 2, -1, -1},  {"PB3", kB, 3, -1, -1, 0, -1, 3, -1, -1},
    {"PB4", kB, 4, -1, 2, 0, -1, 4, -1, -1},   {"PB5", kB, 5, -1, 1, 0, -1, 5, -1, -1},
    {"PB6", kB, 6, -1, 1, 1, -1, 6, -1, -1},   {"PB7", kB, 7, -1, 0, 0, -1, 7, -1, -1},
    {"PC0", kC, 0, -1, -1, 0, -1, -1, -1, -1}, {"PC1", kC, 1, -1, -1, 0, -1, -1, -1, -1},
    {"PC2", kC, 2, -1, -1, 0, -1, -1, -1, -1}, {"PC3", kC, 3, -1, -1, 0, -1, -1, -1, -1},
    {"PC4", kC, 4, -1, -1, 0, -1, -1, -1, -1}, {"PC5", kC, 5, -1, -1, 0, -1, -1, -1, -1},
    {"PC6", kC, 6, -1, -1, 0, -1, -1, -1, -1}, {"PC7", kC, 7, -1, -1, 0, -1, -1, -1, -1},
    {"PD0", kD, 0, -1, -1, 0, 0, -1, -1, -1},  {"PD1", kD, 1, -1, -1, 0, 1, -1, -1, -1},
    {"PD2", kD, 2, -1, -1, 0, 2, -1, -1, -1},  {"PD3", kD, 3, -1, -1, 0, 3, -1, -1, -1},
    {"PD4", kD, 4, -1, -1, 0, -1, -1, -1, 1},  {"PD5", kD, 5, -1, -1, 0, -1, -1, -1, -1},
    {"PD6", kD, 6, -1, -1, 0, -1, -1, 1, -1},  {"PD7", kD, 7, -1, -1, 0, -1, -1, 0, -1},
    {"PE0", kE, 0, -1, -1, 0, -1, 8, -1, -1},  {"PE1", kE, 1, -1, -1, 0, -1, -1, -1, -1},
    {"PE2", kE, 2, -1, -1, 0, -1, -1, -1, -1}, {"PE3", kE, 3, -1, 3, 0, -1, -1, -1, -1},
    {"PE4", kE, 4, -1, 3, 1, 4, -1, -1, -1},   {"PE5", kE, 5, -1, 3, 2, 5, -1, -1, -1},
    {"PE6", kE, 6, -1, -1, 0, 6, -1, 3, -1},   {"PE7", kE, 7, -1, -1, 0, 7, -1, -1, 3},
    {"PF0", kF, 0, 0, -1, 0, -1, -1, -1, -1},  {"PF1", kF, 1, 1, -1, 0, -1, -1, -1, -1},
    {"PF2", kF, 2, 2, -1, 0, -1, -1, -1, -1},  {"PF3", kF, 3, 3, -1, 0, -1, -1, -1, -1},
    {"PF4", kF, 4, 4, -1, 0, -1, -1, -1, -1},  {"PF5", kF, 5, 5, -1, 0, -1, -1, -1, -1},
    {"PF6", kF, 6, 6, -1, 0, -1, -1, -1, -1},  {"PF7", kF, 7, 7, -1, 0, -1, -1, -1, -1},
    {"PG0", kG, 0, -1, -1, 0, -1, -1, -1, -1}, {"PG1", kG, 1, -1, -1, 0, -1, -1, -1, -1},
    {"PG2", kG, 2, -1, -1, 0, -1, -1, -1, -1}, {"PG3", kG, 3, -1, -1, 0, -1, -1, -1, -1},
    {"PG4", kG, 4, -1, -1, 0, -1, -1, -1, -1}, {"PG5", kG, 5, -1, 0, 1, -1, -1, -1, -1},
    {"PH0", kH, 0, -1, -1, 0, -1, -1, -1, -1}, {"PH1", kH, 1, -1, -1, 0, -1, -1, -1, -1},
    {"PH2", kH, 2, -1, -1, 0, -1, -1, -1, -1}, {"PH3", kH, 3, -1, 4, 0, -1, -1, -1, -1},
    {"PH4", kH, 4, -1, 4, 1, -1, -1, -1, -1},  {"PH5", kH, 5, -1, 4, 2, -1, -1, -1, -1},
    {"PH6", kH, 6, -1, 2, 1, -1, -1, -1, -1},  {"PH7", kH, 7, -1, -1, 0, -1, -1, 4, -1},
    {"PJ0", kJ, 0, -1, -1, 0, -1, 9, -1, -1},  {"PJ1", kJ, 1, -1, -1, 0, -1, 10, -1, -1},
    {"PJ2", kJ, 2, -1, -1, 0, -1, 11, -1, -1}, {"PJ3", kJ, 3, -1, -1, 0, -1, 12, -1, -1},
    {"PJ4", kJ, 4, -1, -1, 0, -1, 13, -1, -1}, {"PJ5", kJ, 5, -1, -1, 0, -1, 14, -1, -1},
    {"PJ6", kJ, 6, -1, -1, 0, -1, 15, -1, -1}, {"PJ7", kJ, 7, -1, -1, 0, -1, -1, -1, -1},
    {"PK0", kK, 0, 8, -1, 0, -1, 16, -1, -1},  {"PK1", kK, 1, 9, -1, 0, -1, 17, -1, -1},
    {"PK2", kK, 2, 10, -1, 0, -1, 18, -1, -1}, {"PK3", kK, 3, 11, -1, 0, -1, 19, -1, -1},
    {"PK4", kK, 4, 12, -1, 0, -1, 20, -1, -1}, {"PK5", kK, 5, 13, -1, 0, -1, 21, -1, -1},
    {"PK6", kK, 6, 14, -1, 0, -1, 22, -1, -1}, {"PK7", kK, 7, 15, -1, 0, -1, 23, -1, -1},
    {"PL0", kL, 0, -1, -1, 0, -1, -1, -1, 4},  {"PL1", kL, 1, -1, -1, 0, -1, -1, -1, 5},
    {"PL2", kL, 2, -1, -1, 0, -1, -1, 5, -1},  {"PL3", kL, 3, -1, 5, 0, -1, -1, -1, -1},
    {"PL4", kL, 4, -1, 5, 1, -1, -1, -1, -1},  {"PL5", kL, 5, -1, 5, 2, -1, -1, -1, -1},
    {"PL6", kL, 6, -1, -1, 0, -1, -1, -1, -1}, {"PL7", kL, 7, -1, -1, 0, -1, -1, -1, -1},
};

constexpr uint16_t kPrr0 = 0x64, kPrr1 = 0x65;  // 11.10.2, 11.10.3

// 16, 17 and 20: the timers; vectors: table 14-1
constexpr TimerSpec timer16(uint8_t number, uint32_t control, uint8_t vector, uint16_t reduction) {
  const auto at = [control](int offset) { return static_cast<uint16_t>(control + offset); };
  return {number,
          16,
          control,
          at(4),
          {at(8), at(10), at(12)},
          at(6),
          static_cast<uint16_t>(0x6E + number),
          {0, 1, 8, 64, 256, 1024, 0, 0},
          vector,
          static_cast<uint16_t>(0x35 + number),
          false,
          reduction,
          static_cast<int8_t>(number == 1 ? 3 : number)};
}
constexpr TimerSpec kTimers[] = {
    {0, 8, 0x44, 0x46, {0x47, 0x48}, 0, 0x6E, {0, 1, 8, 64, 256, 1024, 0, 0}, 21, 0x35, false, kPrr0, 5},
    timer16(1, 0x80, 17, kPrr0),
    {2, 8, 0xB0, 0xB2, {0xB3, 0xB4}, 0, 0x70, {0, 1, 8, 32, 64, 128, 256, 1024}, 13, 0x37, true, kPrr0, 6},
    timer16(3, 0x90, 32, kPrr1),
    timer16(4, 0xA0, 42, kPrr1),
    timer16(5, 0x120, 47, kPrr1),
};

// 22: the USARTs
constexpr UartSpec kUarts[] = {{0, 0xC0, 0xC4, 0xC6, 25, "PE0", "PE1", kPrr0, 1},
                               {1, 0xC8, 0xCC, 0xCE, 36, "PD2", "PD3", kPrr1, 0},
                               {2, 0xD0, 0xD4, 0xD6, 51, "PH0", "PH1", kPrr1, 1},
                               {3, 0x130, 0x134, 0x136, 54, "PJ0", "PJ1", kPrr1, 2}};

}  // namespace atmega2560

constexpr ChipSpec kAtmega2560 = {
    .name = "ATmega2560",
    .target = "avr",
    .compiler_name = "atmega2560",
    .architecture = "avr6",
    .macro = "__AVR_ATmega2560__",
    .registers = "iom2560.h",
    .avrdude_name = "atmega2560",
    .signature = {0x1E, 0x98, 0x01},  // 30.3
    .flash_address = 0,
    .flash_bytes = 0x40000,  // 8.1 to 8.3
    .ram_address = 0x200,
    .ram_bytes = 0x2000,
    .eeprom_bytes = 0x1000,
    .return_address_bytes = 3,  // 7.6
    .vectors = 57,              // table 14-1
    .external_vector = 1,
    .external_count = 8,
    .change_vector = 9,
    .change_count = 3,
    .watchdog_vector = 12,
    .eeprom_vector = 30,
    .linked_relaxed = true,
    .pins = atmega2560::kPins,
    .pin_count = sizeof atmega2560::kPins / sizeof *atmega2560::kPins,
    .ports = atmega2560::kPorts,
    .port_count = 11,
    .timers = atmega2560::kTimers,
    .timer_count = 6,
    .uarts = atmega2560::kUarts,
    .uart_count = 4,
    .adc = {.bits = 10,  // 26
            .pins = 16,
            .bandgap_volts = 1.1,
            .bandgap_channel = 0x1E,
            .vector = 29,
            .triggers = {0, 28, 1, 21, 23, 18, 20, 16},  // table 26-6
            .reduction = atmega2560::kPrr0,
            .reduction_bit = 0,
            .references = {0.0, 0.0, 1.1, 2.56},  // table 26-3
            .multiplexer_bits = 0x1F,
            .high_channels = 0x08,
            .control_b_bits = 0x4F},
    .spi = {0x4C, 24, "PB0", "PB2", "PB3", "PB1", atmega2560::kPrr0, 2},  // 21
    .twi = {0xB8, 39, "PD1", "PD0", atmega2560::kPrr0, 7},                // 24
    .comparator = {0x50, 28, "PE2", "PE3", 16, 1},                        // 25
};

}  // namespace robosim
