// Hints for beginners, in addition to a compiler's message.
#pragma once

#include <string>

namespace robosim::build {

/// Returns a sentence for the first error of a sketch that does not compile. Empty if the message itself is
/// clear enough.
std::string hint_for(const std::string& messages);

/// Returns the name of a header's library in Arduino's library manager; empty if it is unknown here.
std::string library_of_header(const std::string& header);

/// Returns the purpose of a header of the AVR core's own libraries, such as "a two-wire bus (I2C)"; empty for
/// any other. Debian's package arduino-core-avr has them.
std::string purpose_of_core_library(const std::string& header);

/// Returns "WiFi.h is for boards with an ESP32 or ESP8266, …" for a header that no library for Robosim's
/// boards has; empty for any other.
std::string foreign_header(const std::string& header);

}  // namespace robosim::build
