// Adds hints for beginners to a compiler's message.
#pragma once

#include <string>

namespace robosim::build {

/// Returns a sentence about the first error of a sketch that does not compile. Returns an empty text if the
/// message itself is clear enough.
std::string hint_for(const std::string& messages);

/// Returns the name of a header's library in Arduino's library manager; empty if the header is unknown here.
std::string library_of_header(const std::string& header);

/// Returns the purpose of a header of the AVR core's own libraries, such as "a two-wire bus (I2C)". Returns
/// an empty text for any other header. Debian's package arduino-core-avr contains these libraries.
std::string purpose_of_core_library(const std::string& header);

/// Returns "WiFi.h is for an ESP32; …" for a header that no library for Robosim's boards provides. Returns an
/// empty text for any other header.
std::string foreign_header(const std::string& header);

}  // namespace robosim::build
