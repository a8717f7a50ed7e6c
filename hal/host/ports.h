// Models ports on the host (data sheet, chapter 14), and maps Arduino pins to bits of ports. The mapping is
// that of the board, or of the board's substitute on the host (BoardSpec::host_model). If the board has more
// pins than the substitute, the other pins belong to additional ports without registers.
#pragma once

#include <stdint.h>

#include "hal/board/board.h"
#include "hal/board/board_spec.h"
#include "hal/host/chip.h"
#include "hal/host/clock.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

/// Index of a port. The ports of ChipSpec::ports come first.
using Port = uint8_t;
constexpr int kBits = 8;
constexpr int kPorts = kChip.port_count + (kPins + kBits - 1) / kBits;

/// The timer channel that can drive a pin.
struct TimerPin {
  int8_t timer = -1;   ///< -1 = none
  int8_t channel = 0;  ///< 0 = A, 1 = B
};

/// The functions of a pin on the chip.
struct Place {
  bool digital = false;  ///< false for pins that are only analog inputs (A6 and A7 of a Nano)
  Port port = 0;
  uint8_t mask = 0;
  TimerPin timer;
  int8_t external = -1;      ///< n of INTn; -1 = none
  int8_t change_group = -1;  ///< group of pin change interrupts; -1 = none
  uint8_t change_mask = 0;   ///< the pin's bit in PCMSKn
  int8_t counted_by = -1;    ///< timer that can count the pin's edges as external clock; -1 = none
  int8_t captured_by = -1;   ///< timer that can capture the pin's edges; -1 = none
  bool no_channel = false;   ///< an analog pin without a channel of the ADC: pins 11 and 12
                             ///< of the Blue Pill, A8 to A15 of a Mega
  Pin wired = 0;             ///< result of first_number() for the pin
  uint16_t off_bits = 0;     ///< bits in inputs_off that switch the pin's digital input off
};
constexpr int kNumbers = 256;  ///< number of values that a sketch may pass as a pin
extern Place places[kNumbers];

inline Port port_of(Pin pin) { return places[pin].port; }
inline uint8_t mask_of(Pin pin) { return places[pin].mask; }
inline bool is_digital(Pin pin) { return places[pin].digital; }
inline TimerPin timer_of(Pin pin) { return places[pin].timer; }
/// Returns the pin of INTn; kNoPin if the board has none.
Pin pin_of_external(int number);
/// Return the pin of ICP1, and the pin of AIN0 (`input` 0) or AIN1 (1).
Pin pin_of_capture();
Pin pin_of_comparator(int input);
/// Initialises the mapping when the firmware starts.
ROBOSIM_RARE void place_pins();

struct PortRegisters {
  uint8_t direction = 0;  ///< DDRx
  uint8_t output = 0;     ///< PORTx
};
extern PortRegisters ports[kPorts];

/// Write a register, and report changes of its pins to the board.
void set_direction(Port port, uint8_t value);
void set_output(Port port, uint8_t value);
/// The digital inputs that are switched off and read low: DIDR0 in the low byte, DIDR1 in the high byte.
extern uint16_t inputs_off;
inline bool is_input_off(Pin pin) { return inputs_off && inputs_off & places[pin].off_bits; }
/// Switches all pull-ups off (PUD), or on where PORTx enables them.
ROBOSIM_RARE void set_pull_ups_off(bool off);
/// Return the level that firmware reads on a pin, and the value that firmware reads from PINx.
bool read_pin(Pin pin);
uint8_t read_port(Port port);

/// The drive of each pin as last reported to the board.
extern PinDrive driven[kPins];
inline bool is_output(Pin pin) { return driven[pin].mode == PinMode::output; }
/// Returns whether a timer drives the pin whenever the pin is an output.
bool is_timed(Pin pin);
/// Returns whether the chip toggles the pin without firmware (waves.h).
bool is_wave(Pin pin);
/// Returns the level of an output pin.
bool output_level(Pin pin);

/// Returns whether a pin has PWM on the board, but no timer on the board's substitute. Such a pin is driven
/// without a timer.
inline bool has_pwm_without_timer(Pin pin) {
  return pin < kPins && places[pin].timer.timer < 0 && board_spec->pins[pin].pwm;
}
/// Drives a pin for which has_pwm_without_timer() is true. PWM has the duty cycle `value` / 255; 0 = no PWM.
void set_pwm(Pin pin, uint8_t value);
/// Ends the PWM that set_pwm() has started, and returns whether the pin had such PWM.
bool end_pwm(Pin pin);

/// Reports the drive of `pin` to the board if it has changed.
void refresh_pin(Pin pin);
void refresh_timer_pins(int timer);
/// Makes `pin` output a square wave for tone(). With `hz` 0, ends the wave.
void set_tone(Pin pin, uint32_t hz);

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
