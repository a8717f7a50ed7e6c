// Describes the ATmega32U4 of an Arduino Leonardo and Micro. Source: data sheet 7766J; numbers in comments
// are its sections.
//
// On the chip, some pins are outputs of two timers. In this table each pin has only one timer, as in
// Arduino's core: PB7 is OC0A (not OC1C), PB6 is OC1B (not OC4B), and PC6 is OC3A.
#pragma once

#include "hal/board/chip_spec.h"

namespace robosim {
namespace atmega32u4 {

// 31: the register summary
constexpr PortSpec kPorts[] = {{'B', 0x23}, {'C', 0x26}, {'D', 0x29}, {'E', 0x2C}, {'F', 0x2F}};
constexpr int8_t kB = 0, kC = 1, kD = 2, kE = 3, kF = 4;

// 1 and 10.3: the pins. Timers are given by their index in kTimers.
constexpr ChipPin kPins[] = {
    // name, port, bit, ADC, timer, output, INT, PCINT, T, ICP
    {"PB0", kB, 0, -1, -1, 0, -1, 0, -1, -1},  {"PB1", kB, 1, -1, -1, 0, -1, 1, -1, -1},
    {"PB2", kB, 2, -1, -1, 0, -1, 2, -1, -1},  {"PB3", kB, 3, -1, -1, 0, -1, 3, -1, -1},
    {"PB4", kB, 4, 11, -1, 0, -1, 4, -1, -1},  {"PB5", kB, 5, 12, 1, 0, -1, 5, -1, -1},
    {"PB6", kB, 6, 13, 1, 1, -1, 6, -1, -1},   {"PB7", kB, 7, -1, 0, 0, -1, 7, -1, -1},
    {"PC6", kC, 6, -1, 2, 0, -1, -1, -1, -1},  {"PC7", kC, 7, -1, 3, 0, -1, -1, -1, 2},
    {"PD0", kD, 0, -1, 0, 1, 0, -1, -1, -1},   {"PD1", kD, 1, -1, -1, 0, 1, -1, -1, -1},
    {"PD2", kD, 2, -1, -1, 0, 2, -1, -1, -1},  {"PD3", kD, 3, -1, -1, 0, 3, -1, -1, -1},
    {"PD4", kD, 4, 8, -1, 0, -1, -1, -1, 1},   {"PD5", kD, 5, -1, -1, 0, -1, -1, -1, -1},
    {"PD6", kD, 6, 9, -1, 0, -1, -1, 1, -1},   {"PD7", kD, 7, 10, 3, 3, -1, -1, 0, -1},
    {"PE2", kE, 2, -1, -1, 0, -1, -1, -1, -1}, {"PE6", kE, 6, -1, -1, 0, 6, -1, -1, -1},
    {"PF0", kF, 0, 0, -1, 0, -1, -1, -1, -1},  {"PF1", kF, 1, 1, -1, 0, -1, -1, -1, -1},
    {"PF4", kF, 4, 4, -1, 0, -1, -1, -1, -1},  {"PF5", kF, 5, 5, -1, 0, -1, -1, -1, -1},
    {"PF6", kF, 6, 6, -1, 0, -1, -1, -1, -1},  {"PF7", kF, 7, 7, -1, 0, -1, -1, -1, -1},
};

constexpr uint16_t kPrr0 = 0x64, kPrr1 = 0x65;  // 7.9.2, 7.9.3

// 13, 14 and 15: the timers; vectors: table 9-1
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
          3};
}
constexpr TimerSpec kTimers[] = {
    {0, 8, 0x44, 0x46, {0x47, 0x48}, 0, 0x6E, {0, 1, 8, 64, 256, 1024, 0, 0}, 21, 0x35, false, kPrr0, 5},
    timer16(1, 0x80, 17, kPrr0),
    timer16(3, 0x90, 32, kPrr1),
    {4, kHighSpeedBits, 0xC0, 0xBE, {0xCF, 0xD0}, 0, 0x72, {}, 38, 0x39, false, kPrr1, 4},
};

// 18: the USART
constexpr UartSpec kUarts[] = {{1, 0xC8, 0xCC, 0xCE, 25, "PD2", "PD3", kPrr1, 0}};

}  // namespace atmega32u4

constexpr ChipSpec kAtmega32u4 = {
    .name = "ATmega32U4",
    .target = "avr",
    .compiler_name = "atmega32u4",
    .architecture = "avr5",
    .macro = "__AVR_ATmega32U4__",
    .registers = "iom32u4.h",
    .avrdude_name = "atmega32u4",
    .signature = {0x1E, 0x95, 0x87},  // 28.3
    .flash_address = 0,
    .flash_bytes = 0x8000,  // 5.1 to 5.3
    .ram_address = 0x100,
    .ram_bytes = 0xA00,
    .eeprom_bytes = 0x400,
    .return_address_bytes = 2,  // 4.6
    .vectors = 43,              // table 9-1
    .external_vector = 1,
    .external_count = 7,  // INT4 and INT5 do not exist
    .change_vector = 9,
    .change_count = 1,
    .watchdog_vector = 12,
    .eeprom_vector = 30,
    .pins = atmega32u4::kPins,
    .pin_count = sizeof atmega32u4::kPins / sizeof *atmega32u4::kPins,
    .ports = atmega32u4::kPorts,
    .port_count = 5,
    .timers = atmega32u4::kTimers,
    .timer_count = 4,
    .uarts = atmega32u4::kUarts,
    .uart_count = 1,
    .adc = {.bits = 10,  // 24
            .pins = 14,
            .bandgap_volts = 1.1,
            .bandgap_channel = 0x1E,
            .vector = 29,
            .triggers = {0, 28, 1, 21, 23, 18, 20, 16},  // table 24-6, without triggers by timer 4
            .reduction = atmega32u4::kPrr0,
            .reduction_bit = 0,
            .references = {0.0, 0.0, 0.0, 2.56},  // table 24-3
            .multiplexer_bits = 0x1F,
            .high_channels = 0x20,
            .control_b_bits = 0xF7},
    .spi = {0x4C, 24, "PB0", "PB2", "PB3", "PB1", atmega32u4::kPrr0, 2},  // 17
    .twi = {0xB8, 36, "PD1", "PD0", atmega32u4::kPrr0, 7},                // 20
    .comparator = {0x50, 28, "PE6", "", 8, 1},                            // 23
    .usb = {0xD8, 0x49, 10, atmega32u4::kPrr1, 7},                        // 21, 22
};

}  // namespace robosim
