// Describes the ATtiny85 of a Digispark and a Gemma. Source: data sheet 2586Q; comments give section numbers.
//
// Not modelled: the USI (15), and some features of timer 1 (listed in sim/mcu/avr/timer_pll.cpp). On the
// chip, PB1 is the output OC0B of timer 0 and the output OC1A of timer 1. In this table PB1 is only OC0B, as
// in Arduino's core.
#pragma once

#include "hal/board/chip_spec.h"

namespace robosim {
namespace attiny85 {

// 24: the register summary
constexpr PortSpec kPorts[] = {{'B', 0x36}};

// 1 and 10.2: the pins. By default PB5 is the reset input; a fuse makes it an ordinary pin. Timers are given
// by their index in kTimers.
constexpr ChipPin kPins[] = {
    // name, port, bit, ADC, timer, output, INT, PCINT, T, ICP
    {"PB0", 0, 0, -1, 0, 0, -1, 0, -1, -1}, {"PB1", 0, 1, -1, 0, 1, -1, 1, -1, -1},
    {"PB2", 0, 2, 1, -1, 0, 0, 2, 0, -1},   {"PB3", 0, 3, 3, -1, 0, -1, 3, -1, -1},
    {"PB4", 0, 4, 2, 1, 1, -1, 4, -1, -1},  {"PB5", 0, 5, 0, -1, 0, -1, 5, -1, -1},
};

constexpr uint16_t kPrr = 0x40;  // 7.5.2

// 11 and 12: the timers; vectors: table 9-1
constexpr TimerSpec timer0() {
  TimerSpec timer = {0,    8,     0x4A, 0x52, {0x49, 0x48}, 0, 0x59, {0, 1, 8, 64, 256, 1024, 0, 0}, 10,
                     0x58, false, kPrr, 2};
  timer.control_b = 0x53;
  timer.overflow_vector = 5;
  timer.flag_bits[0] = 1;
  timer.flag_bits[1] = 4;
  timer.flag_bits[2] = 3;
  return timer;
}
constexpr TimerSpec timer1() {
  TimerSpec timer = {1, 8, 0x50, 0x4F, {0x4E, 0x4B}, 0, 0x59, {}, 3, 0x58, true, kPrr, 3};
  timer.top = 0x4D;
  timer.pins[0] = "PB1";
  timer.overflow_vector = 4;
  timer.match_b_vector = 9;
  timer.flag_bits[0] = 2;
  timer.flag_bits[1] = 6;
  timer.flag_bits[2] = 5;
  return timer;
}
constexpr TimerSpec kTimers[] = {timer0(), timer1()};

}  // namespace attiny85

constexpr ChipSpec kAttiny85 = {
    .name = "ATtiny85",
    .target = "avr",
    .compiler_name = "attiny85",
    .architecture = "avr25",
    .macro = "__AVR_ATtiny85__",
    .registers = "iotn85.h",
    .avrdude_name = "attiny85",
    .signature = {0x1E, 0x93, 0x0B},  // 20.3
    .flash_address = 0,
    .flash_bytes = 0x2000,  // 5.1 to 5.3
    .ram_address = 0x60,
    .ram_bytes = 0x200,
    .eeprom_bytes = 0x200,
    .return_address_bytes = 2,  // 4.6
    .vectors = 15,              // table 9-1
    .external_vector = 1,
    .external_count = 1,
    .change_vector = 2,
    .change_count = 1,
    .watchdog_vector = 12,
    .eeprom_vector = 6,
    .small_core = true,    // 25
    .start_up_cycles = 6,  // table 6-5: the internal oscillator
    .pins = attiny85::kPins,
    .pin_count = sizeof attiny85::kPins / sizeof *attiny85::kPins,
    .ports = attiny85::kPorts,
    .port_count = 1,
    .timers = attiny85::kTimers,
    .timer_count = 2,
    .uarts = nullptr,
    .uart_count = 0,
    .adc = {.bits = 10,  // 17
            .pins = 4,
            .bandgap_volts = 1.1,
            .bandgap_channel = 12,
            .vector = 8,
            .triggers = {0, 7, 1, 10, 5, 11, 2, 0},  // table 17-6
            .reduction = attiny85::kPrr,
            .reduction_bit = 0,
            .references = {0.0, 0.0, 1.1, 0.0, 0.0, 0.0, 2.56, 2.56},  // table 17-3
            .reference_bit = 0x10,
            .control_b_bits = 0xE7},
    .comparator = {0x28, 7, "PB0", "PB1", 4},  // 16
    .at = {.external_sense = 0x55,             // MCUCR: 9.3.1, 7.5.1, 10.4.1
           .external_enables = 0x5B,           // GIMSK, GIFR: 9.3.2, 9.3.3
           .external_flags = 0x5A,
           .external_bit = 6,
           .change_enables = 0x5B,
           .change_flags = 0x5A,
           .change_bit = 5,
           .change_masks = 0x35,  // 9.3.4
           .pull_ups_off = 0x40,
           .sleep = 0x55,
           .sleep_enable = 0x20,
           .sleep_modes = 0x18,
           .clock_divisor = 0x46,  // 6.5.2
           .watchdog = 0x41,       // 8.5.2
           .timers = 0x4C,         // GTCCR: 11.9.1, 12.3.2
           .timers_kept = 0x70,
           .pll = 0x47,       // 12.3.9
           .eeprom = 0x3C,    // 5.5
           .adc_data = 0x24,  // 17.13
           .adc_control = 0x26,
           .adc_control_b = 0x23,
           .adc_multiplexer = 0x27,
           .digital_off = {0x34, 0x34, 0x34},  // 17.13.5
           .general = {0x31, 0x32}},           // 5.5.5 to 5.5.7
};

}  // namespace robosim
