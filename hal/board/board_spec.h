// Boards and their pins, as data.
#pragma once

#include <stdint.h>

#include "hal/board/board.h"

namespace robosim {

/// One pin of a board. Sources: ATmega328P datasheet (DS40002061B) and the Arduino core's
/// `variants/standard/pins_arduino.h`; STM32F103x8 datasheet (DS5319).
struct PinSpec {
  const char* name;       ///< Arduino's name: "D5", "A0"
  const char* chip_name;  ///< the chip's name: "PD5"
  int8_t analog_channel;  ///< ADC channel; -1 = no analog input
  bool pwm;               ///< analogWrite gives hardware PWM
  int8_t interrupt;       ///< number for attachInterrupt; -1 = none
  bool digital;           ///< false: analog input only (A6, A7 of a Nano)
};

struct BoardSpec {
  const char* name;   ///< as robot files write it: "uno"
  const char* fqbn;   ///< as arduino-cli writes it: "arduino:avr:uno"
  const char* macro;  ///< what the core defines: "ARDUINO_AVR_UNO"
  uint8_t pin_count;  ///< pins are numbered 0 .. pin_count-1
  const PinSpec* pins;
  uint8_t analog_pin_0;  ///< Arduino number of A0
  double supply_volts;   ///< VCC and the ADC's default reference
  uint16_t adc_steps;    ///< codes are 0 .. adc_steps-1; analogRead's range
  uint32_t clock_hz;
  uint32_t flash_bytes;  ///< for the sketch, without the boot loader
  uint32_t ram_bytes;
  uint16_t eeprom_bytes;
  uint8_t led_builtin;
};

/// The board of that name, or null. Names are listed by board_at.
const BoardSpec* find_board(const char* name);
/// The board of that number, from 0; null past the last.
const BoardSpec* board_at(int number);
/// A pin by what people write: "5", "D5", "A0", "PD5" (case does not matter). kNoPin if the board has none
/// such.
Pin find_pin(const BoardSpec& board, const char* name);

}  // namespace robosim
