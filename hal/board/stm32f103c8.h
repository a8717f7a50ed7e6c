// Describes the STM32F103C8 of a Blue Pill. Sources: data sheet DS5319, reference manual RM0008 rev. 21;
// numbers in comments are sections of RM0008. hal/stm32/addresses.h has the other registers.
#pragma once

#include "hal/board/chip_spec.h"

namespace robosim {
namespace stm32f103c8 {

// 3.3: the memory map
constexpr PortSpec kPorts[] = {{'A', 0x40010800}, {'B', 0x40010C00}, {'C', 0x40011000}};
constexpr int8_t kA = 0, kB = 1, kC = 2;

// Indices of kTimers
constexpr int8_t kTim1 = 0, kTim2 = 1, kTim3 = 2, kTim4 = 3;

constexpr ChipPin pin(const char* name, int8_t port, uint8_t bit, int8_t analog_channel = -1,
                      int8_t timer = -1, uint8_t output = 0) {
  return {name, port, bit, analog_channel, timer, output, static_cast<int8_t>(bit), -1, -1, -1};
}

// DS5319, table 5: the pins' functions after a reset. PA13, PA14 and PB2 are missing: the debugger uses PA13
// and PA14, and PB2 is BOOT1.
constexpr ChipPin kPins[] = {
    pin("PA0", kA, 0, 0, kTim2, 0),
    pin("PA1", kA, 1, 1, kTim2, 1),
    pin("PA2", kA, 2, 2, kTim2, 2),
    pin("PA3", kA, 3, 3, kTim2, 3),
    pin("PA4", kA, 4, 4),
    pin("PA5", kA, 5, 5),
    pin("PA6", kA, 6, 6, kTim3, 0),
    pin("PA7", kA, 7, 7, kTim3, 1),
    pin("PA8", kA, 8, -1, kTim1, 0),
    pin("PA9", kA, 9, -1, kTim1, 1),
    pin("PA10", kA, 10, -1, kTim1, 2),
    pin("PA11", kA, 11, -1, kTim1, 3),
    pin("PA12", kA, 12),
    pin("PA15", kA, 15),
    pin("PB0", kB, 0, 8, kTim3, 2),
    pin("PB1", kB, 1, 9, kTim3, 3),
    pin("PB3", kB, 3),
    pin("PB4", kB, 4),
    pin("PB5", kB, 5),
    pin("PB6", kB, 6, -1, kTim4, 0),
    pin("PB7", kB, 7, -1, kTim4, 1),
    pin("PB8", kB, 8, -1, kTim4, 2),
    pin("PB9", kB, 9, -1, kTim4, 3),
    pin("PB10", kB, 10),
    pin("PB11", kB, 11),
    pin("PB12", kB, 12),
    pin("PB13", kB, 13),
    pin("PB14", kB, 14),
    pin("PB15", kB, 15),
    pin("PC13", kC, 13),
    pin("PC14", kC, 14),
    pin("PC15", kC, 15),
};

constexpr TimerSpec timer(uint8_t number, uint32_t address, uint8_t vector) {
  return {number, 16, address, 0, {}, 0, 0, {}, vector};
}
// 14 and 15: the timers; interrupts: table 63
constexpr TimerSpec kTimers[] = {
    timer(1, 0x40012C00, 25),
    timer(2, 0x40000000, 28),
    timer(3, 0x40000400, 29),
    timer(4, 0x40000800, 30),
};

// 27: the USARTs; interrupts: table 63. The core uses only the first USART.
constexpr UartSpec kUarts[] = {{1, 0x40013800, 0, 0, 37, "PA10", "PA9"},
                               {2, 0x40004400, 0, 0, 38, "PA3", "PA2"},
                               {3, 0x40004800, 0, 0, 39, "PB11", "PB10"}};

}  // namespace stm32f103c8

constexpr ChipSpec kStm32f103c8 = {
    .name = "STM32F103C8",
    .target = "stm32",
    .compiler_name = "stm32f103c8",
    .architecture = nullptr,
    .macro = nullptr,
    .registers = nullptr,
    .avrdude_name = nullptr,
    .signature = {},
    .flash_address = 0x08000000,  // 3.3
    .flash_bytes = 64 * 1024,
    .ram_address = 0x20000000,
    .ram_bytes = 20 * 1024,
    .eeprom_bytes = 0,
    .return_address_bytes = 0,
    .vectors = 16 + 43,  // 10.1.2, table 63
    .external_vector = 6,
    .external_count = 16,
    .change_vector = 0,
    .change_count = 0,
    .pins = stm32f103c8::kPins,
    .pin_count = sizeof stm32f103c8::kPins / sizeof *stm32f103c8::kPins,
    .ports = stm32f103c8::kPorts,
    .port_count = 3,
    .timers = stm32f103c8::kTimers,
    .timer_count = 4,
    .uarts = stm32f103c8::kUarts,
    .uart_count = 1,  // the core uses only the first
    .adc = {.bits = 12, .pins = 10, .bandgap_volts = 0.0, .bandgap_channel = -1, .vector = 18},  // 11
};

}  // namespace robosim
