// What a beginner would want to be told beside a compiler's message.
#pragma once

#include <string>

namespace robosim::build {

/// A sentence for the first error of a sketch that does not compile; empty where the message itself says what
/// to do.
std::string hint_for(const std::string& messages);

/// What Arduino's library manager calls the library of a header; empty where that is not known here.
std::string library_of_header(const std::string& header);

/// What a header of the AVR core's own libraries is for, such as "a two-wire bus (I2C)"; empty for any other.
/// Debian's package arduino-core-avr brings them.
std::string purpose_of_core_library(const std::string& header);

/// "WiFi.h is for boards with an ESP32 or ESP8266, …" of a header that no library for Robosim's boards has;
/// empty for any other.
std::string foreign_header(const std::string& header);

}  // namespace robosim::build
