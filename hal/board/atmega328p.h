// Describes the ATmega328P of an Uno, Nano and Pro Mini. Source: data sheet DS40002061B; numbers in comments
// are its sections.
#pragma once

#include "hal/board/chip_spec.h"

namespace robosim {
namespace atmega328p {

// 36: the register summary
constexpr PortSpec kPorts[] = {{'B', 0x23}, {'C', 0x26}, {'D', 0x29}};
constexpr int8_t kB = 0, kC = 1, kD = 2;

// 5: the pins. Timers are given by their index in kTimers.
constexpr ChipPin kPins[] = {
    // name, port, bit, ADC, timer, output, INT, PCINT, T, ICP
    {"PB0", kB, 0, -1, -1, 0, -1, 0, -1, 1},   {"PB1", kB, 1, -1, 1, 0, -1, 1, -1, -1},
    {"PB2", kB, 2, -1, 1, 1, -1, 2, -1, -1},   {"PB3", kB, 3, -1, 2, 0, -1, 3, -1, -1},
    {"PB4", kB, 4, -1, -1, 0, -1, 4, -1, -1},  {"PB5", kB, 5, -1, -1, 0, -1, 5, -1, -1},
    {"PC0", kC, 0, 0, -1, 0, -1, 8, -1, -1},   {"PC1", kC, 1, 1, -1, 0, -1, 9, -1, -1},
    {"PC2", kC, 2, 2, -1, 0, -1, 10, -1, -1},  {"PC3", kC, 3, 3, -1, 0, -1, 11, -1, -1},
    {"PC4", kC, 4, 4, -1, 0, -1, 12, -1, -1},  {"PC5", kC, 5, 5, -1, 0, -1, 13, -1, -1},
    {"PD0", kD, 0, -1, -1, 0, -1, 16, -1, -1}, {"PD1", kD, 1, -1, -1, 0, -1, 17, -1, -1},
    {"PD2", kD, 2, -1, -1, 0, 0, 18, -1, -1},  {"PD3", kD, 3, -1, 2, 1, 1, 19, -1, -1},
    {"PD4", kD, 4, -1, -1, 0, -1, 20, 0, -1},  {"PD5", kD, 5, -1, 0, 1, -1, 21, 1, -1},
    {"PD6", kD, 6, -1, 0, 0, -1, 22, -1, -1},  {"PD7", kD, 7, -1, -1, 0, -1, 23, -1, -1},
    {"ADC6", -1, 0, 6, -1, 0, -1, -1, -1, -1}, {"ADC7", -1, 0, 7, -1, 0, -1, -1, -1, -1},
};

// 15, 16 and 18: the timers; vectors: table 12-6; PRR: 10.11.3
constexpr TimerSpec kTimers[] = {
    {0, 8, 0x44, 0x46, {0x47, 0x48}, 0, 0x6E, {0, 1, 8, 64, 256, 1024, 0, 0}, 14, 0x35, false, 0x64, 5},
    {1, 16, 0x80, 0x84, {0x88, 0x8A}, 0x86, 0x6F, {0, 1, 8, 64, 256, 1024, 0, 0}, 11, 0x36, false, 0x64, 3},
    {2, 8, 0xB0, 0xB2, {0xB3, 0xB4}, 0, 0x70, {0, 1, 8, 32, 64, 128, 256, 1024}, 7, 0x37, true, 0x64, 6},
};

// 20: the USART
constexpr UartSpec kUarts[] = {{0, 0xC0, 0xC4, 0xC6, 18, "PD0", "PD1", 0x64, 1}};

}  // namespace atmega328p

constexpr ChipSpec kAtmega328p = {
    .name = "ATmega328P",
    .target = "avr",
    .compiler_name = "atmega328p",
    .architecture = "avr5",
    .macro = "__AVR_ATmega328P__",
    .registers = "iom328p.h",
    .avrdude_name = "atmega328p",
    .signature = {0x1E, 0x95, 0x0F},  // 28.3
    .flash_address = 0,
    .flash_bytes = 0x8000,  // 8.2 to 8.4
    .ram_address = 0x100,
    .ram_bytes = 0x800,
    .eeprom_bytes = 0x400,
    .return_address_bytes = 2,  // 7.5
    .vectors = 26,              // table 12-6
    .external_vector = 1,
    .external_count = 2,
    .change_vector = 3,
    .change_count = 3,
    .watchdog_vector = 6,
    .eeprom_vector = 22,
    .pins = atmega328p::kPins,
    .pin_count = sizeof atmega328p::kPins / sizeof *atmega328p::kPins,
    .ports = atmega328p::kPorts,
    .port_count = 3,
    .timers = atmega328p::kTimers,
    .timer_count = 3,
    .uarts = atmega328p::kUarts,
    .uart_count = 1,
    .adc = {.bits = 10,  // 24
            .pins = 8,
            .bandgap_volts = 1.1,
            .bandgap_channel = 14,
            .vector = 21,
            .triggers = {0, 23, 1, 14, 16, 12, 13, 10},  // table 24-6
            .reduction = 0x64,
            .reduction_bit = 0,
            .references = {0.0, 0.0, 0.0, 1.1}},             // table 24-3
    .spi = {0x4C, 17, "PB2", "PB3", "PB4", "PB5", 0x64, 2},  // 19
    .twi = {0xB8, 24, "PC4", "PC5", 0x64, 7},                // 21
    .comparator = {0x50, 23, "PD6", "PD7", 8, 1},            // 23
};

}  // namespace robosim
