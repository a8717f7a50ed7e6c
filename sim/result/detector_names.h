// Lists all detectors of behaviour that would fail on a real robot. Reports, JSON (`detected`) and
// docs/howto/sanitizers.md use these names.
#pragma once

#include <algorithm>
#include <iterator>
#include <string_view>

namespace robosim::result {

struct DetectorName {
  std::string_view name;
  std::string_view targets;  ///< targets on which the detector works: "all", "host, avr" or "avr"
  std::string_view finds;    ///< the finding, a sentence in Markdown
};

inline constexpr DetectorName kDetectorNames[] = {
    {"blind", "all", "The robot lost the line while it drove too far without reading a floor sensor."},
    {"motors_left_on", "all",
     "The line was gone, and the robot drove 0.5 m more without steering or stopping."},
    {"slow_serial", "all", "Printing slowed down steering, because it waited for `Serial`."},
    {"slow_control", "all",
     "The robot lost the line because its motors changed too rarely, although sensors were read."},
    {"forgotten_output", "all", "A pin with a part was written HIGH, but never set to OUTPUT."},
    {"driven_input", "all", "A pin was an output, although the sketch should read the pin's part."},
    {"floating_input", "all",
     "The pin of a button was read while nothing gave it a level: neither a pull-up nor a resistor."},
    {"eeprom_wear", "host, avr",
     "An EEPROM byte wears out in a day, or is written repeatedly with the same value."},
    {"torn_record", "host, avr",
     "A power cut leaves a number in EEPROM half old and half new, and the number has no check value."},
    {"overwritten_record", "host, avr", "An EEPROM byte was written 8 times in a row with different values."},
    {"lost_pwm", "host, avr",
     "`analogWrite()` was called on a pin without PWM, or on a pin whose timer is used for something else."},
    {"pwm_range", "host, avr", "`analogWrite()` was called with a value below 0 or above 255."},
    {"missing_pin", "host, avr",
     "`pinMode()`, `digitalWrite()`, `digitalRead()` or `analogWrite()` got a number that is not a digital "
     "pin."},
    {"no_interrupt", "host, avr",
     "`attachInterrupt()` was called with a number that the board does not have."},
    {"long_delay", "host, avr", "`delay()` was called with a negative number, or with more than 24 days."},
    {"slow_source", "host, avr", "A pin was read before its source had charged the converter's capacitor."},
    {"lost_edge", "avr",
     "A second edge came at an encoder's or receiver's pin before the handler of the first edge began."},
    {"lost_byte", "avr", "A byte arrived before the handler had read the previous bytes."},
    {"lost_tick", "avr", "A second tick of `millis()` came before the handler of the first tick began."},
    {"torn_read", "avr", "A handler can change a number while the sketch reads its bytes one by one."},
    {"torn_write", "avr", "A handler can change a number while the sketch writes its bytes one by one."},
    {"lost_update", "avr",
     "If a handler changes a byte while the sketch changes it, the handler's change can be lost."},
    {"float_equality", "avr",
     "A float was compared by `==` or `!=` with a number that it passed but never equalled."},
    {"reference_change", "avr",
     "The sketch used the result of the first `analogRead()` after `analogReference()`."},
    {"heap_grows", "avr", "The heap keeps growing."},
    {"heap_in_pieces", "avr",
     "The heap grows although enough bytes are free, because the free pieces are too small."},
    {"no_memory", "avr", "`malloc()` failed."},
    {"stack_margin", "avr",
     "A handler at the deepest stack would overwrite variables, or leave under 16 bytes free."},
    {"nested_loop", "avr", "Three calls of `loop()` are active at once, each inside the previous call."},
    {"busy_handlers", "avr", "Interrupt handlers took 70 % of the processor's time or more."},
    {"watchdog_bite", "avr", "The watchdog reset the chip while the sketch was not in an empty loop."},
    {"watchdog_margin", "avr", "Over 80 % of the watchdog's timeout passed between two feeds."},
    {"clock_wrap", "avr", "The robot behaves differently when `millis()` or `micros()` wraps to 0."},
};

/// Returns `name`. Fails to compile if the list does not contain `name`.
consteval const char* detector(const char* name) {
  const auto is_it = [name](const DetectorName& one) { return one.name == name; };
  if (std::none_of(std::begin(kDetectorNames), std::end(kDetectorNames), is_it)) throw "not a detector";
  return name;
}

}  // namespace robosim::result
