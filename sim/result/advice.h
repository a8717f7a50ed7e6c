// Defines advice that the judge gives after a run, and that `robosim` gives after a second run with sanitizer
// checks.
#pragma once

#include <string>

namespace robosim::result {

inline constexpr const char* kTryHost =
    "run it on the host as well: if it keeps the line there, look for an int that exceeds 32767, as in 1000 "
    "* analogRead(A1); on the chip, an int has 16 bits, and the compiler does not warn about it";
inline constexpr const char* kIfNot = ". If not, ";  ///< joins kTryHost and further advice
inline constexpr const char* kAlso = "; ";           ///< joins other advice and kTryHost
inline constexpr const char* kWatch = "watch it in slow motion, or record what the sensors saw";

inline constexpr const char* kTryWirings =
    "either the sketch reacts too late or the wrong way, or the wiring differs from the robot file (the "
    "order of the sensors, their values over black, a motor's side or direction): robosim wire tries the "
    "alternatives";

/// Returns `advice`, or an empty string if `advice` contains kTryWirings.
std::string without_wirings(const std::string& advice);

/// Returns `advice` without kTryHost. If nothing else remains, returns kWatch.
std::string without_host(std::string advice);

}  // namespace robosim::result
