// Describes boards and their pins as data. To add a board, add an entry to kBoards in board_spec.cpp. Also
// add a table of its pins, if no other board has the same pins. If a board is a variant of another board,
// list only the differences.
#pragma once

#include <stdint.h>

#include "hal/board/board.h"
#include "hal/board/chip_spec.h"

namespace robosim {

/// One pin of a board. Source of the names: the Arduino core's `variants/*/pins_arduino.h`.
struct PinSpec {
  const char* name;       ///< Arduino's name: "D5", "A0"
  const char* chip_name;  ///< the chip's name: "PD5"
  int8_t analog_channel;  ///< ADC channel; -1 = no analog input
  bool pwm;               ///< analogWrite produces hardware PWM
  int8_t interrupt;       ///< interrupt number for attachInterrupt; -1 = none
  bool digital;           ///< false: the pin is only an analog input (A6, A7 of a Nano)
  ChipPin chip_pin;       ///< the pin's other functions on the chip
};

struct BoardSpec {
  const char* name;        ///< the name in robot files: "uno"
  const char* fqbn;        ///< the name for arduino-cli: "arduino:avr:uno"
  const char* platformio;  ///< the names for PlatformIO, separated by spaces: "uno"
  const char* macro;       ///< the macro that the core defines: "ARDUINO_AVR_UNO"
  const ChipSpec* chip;
  const PinSpec* pins;
  uint8_t pin_count;     ///< pins are numbered 0 .. pin_count-1
  uint8_t analog_pin_0;  ///< Arduino number of A0
  uint8_t led_builtin;
  double supply_volts;  ///< VCC and the ADC's default reference
  uint32_t clock_hz;
  uint16_t adc_steps;     ///< analogRead returns 0 .. adc_steps-1
  uint32_t flash_bytes;   ///< flash for the sketch, without the boot loader
  uint32_t ram_bytes;     ///< RAM of the chip
  uint16_t eeprom_bytes;  ///< size of the chip's EEPROM, or of the EEPROM that the core emulates in flash

  double regulator_drop_volts;  ///< drop from battery to supply, including the diode before the regulator
  double brown_out_volts;       ///< a lower supply holds the chip in reset

  /// The board whose registers, timers and clock the target host simulates for this board; null = this board.
  const BoardSpec* host_model;
  const char* variant;    ///< the folder of the board's pins in the genuine core; null = Robosim's own core
  const char* pin_names;  ///< a header of Robosim with more pin names, for the target host; null = none
  const char* upload_protocol;   ///< avrdude's programmer name; null = avrdude cannot write to the board
  uint32_t upload_baud;          ///< the boot loader's baud rate
  uint32_t upload_baud_old;      ///< the baud rate of older boards' boot loader; 0 = upload_baud
  bool upload_by_touch = false;  ///< the boot loader starts when the port is opened with 1200 baud and closed

  uint8_t serial_line = 0;            ///< line to the computer: index of a UART; for USB, the number of UARTs
  const char* usb_product = nullptr;  ///< the product's name in the core, if the chip has USB
  uint16_t usb_id = 0;                ///< USB product id; the vendor id is 0x2341, Arduino
};

/// Returns the board called `name`, or null if it does not exist. board_at() returns all boards, one by one.
const BoardSpec* find_board(const char* name);
/// Returns the board at the index `number`, or null if there are fewer boards.
const BoardSpec* board_at(int number);
/// Returns a pin by any of its usual names: "5", "D5", "A0", "PD5" (case does not matter). Returns kNoPin if
/// the board does not have the pin.
Pin find_pin(const BoardSpec& board, const char* name);
/// Returns the highest number of a digital pin.
Pin last_digital_pin(const BoardSpec& board);

/// Returns the lowest of the Arduino numbers that denote the same chip pin as `pin`. Wires are stored under
/// the lowest number. For example, a Leonardo's A6 has the numbers 24 and 4.
inline Pin first_number(const BoardSpec& board, Pin pin) {
  const ChipPin& place = board.pins[pin].chip_pin;
  for (Pin first = 0; first < pin; ++first) {
    const ChipPin& other = board.pins[first].chip_pin;
    if (other.port == place.port && other.bit == place.bit && other.analog_channel == place.analog_channel)
      return first;
  }
  return pin;
}

inline const BoardSpec& host_model(const BoardSpec& board) {
  return board.host_model ? *board.host_model : board;
}

/// Returns the value from 0 to 255 with which analogWrite() has the same effect as with `value`. The pin must
/// have PWM. An 8-bit timer's register takes the low byte. In a 16-bit timer's register, a value outside 0 to
/// 255 is above TOP, which means full power. An STM32's core limits the value.
inline uint8_t pwm_effect(const BoardSpec& board, Pin pin, int64_t value) {
  constexpr uint8_t kFull = 255;
  if (value >= 0 && value <= kFull) return static_cast<uint8_t>(value);
  const int timer = board.pins[pin].chip_pin.timer;
  const bool is_avr = board.chip->return_address_bytes != 0;
  if (!is_avr) return value < 0 ? 0 : kFull;
  return timer >= 0 && board.chip->timers[timer].bits == 16 ? kFull : static_cast<uint8_t>(value);
}

/// Returns whether a timer can capture the pin's edges, on the chip or in the host's model of it. As soon as
/// firmware reads such a timer's flags, the timer requests these edges, even if nothing uses the captures.
/// The Servo library reads the flags.
inline bool can_capture(const BoardSpec& board, Pin pin) {
  const BoardSpec& model = host_model(board);
  return board.pins[pin].chip_pin.captured_by >= 0 ||
         (pin < model.pin_count && model.pins[pin].chip_pin.captured_by >= 0);
}

}  // namespace robosim
