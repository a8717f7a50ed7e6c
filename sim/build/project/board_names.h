// Finds boards by their names in other tools.
#pragma once

#include <string>

#include "hal/board/board_spec.h"

namespace robosim::project {

/// Returns the board of an FQBN, VENDOR:ARCHITECTURE:BOARD[:KEY=VALUE,…], or null. A missing option has
/// Arduino's default. The option cpu=… must name the board's chip ("atmega328old"). Any other option may have
/// any value if it does not distinguish Robosim's boards.
const BoardSpec* board_of_fqbn(const std::string& fqbn);

/// Returns a board with the chip that avr-gcc calls `chip` ("atmega328p", "atmega328"), or null. If a
/// third-party FQBN specifies a clock ("clock=8MHz_internal"), the board has this clock.
const BoardSpec* board_with_chip(const std::string& chip, const std::string& fqbn);

/// Returns the board with PlatformIO's id ("nanoatmega328"), or null.
const BoardSpec* board_of_platformio(const std::string& id);

/// Return all boards in the notation of arduino-cli ("arduino:avr:uno, …") and of PlatformIO ("uno, …").
std::string all_fqbns();
std::string all_platformio_ids();

}  // namespace robosim::project
