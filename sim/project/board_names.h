// Boards by the names that other tools have for them.
#pragma once

#include <string>

#include "hal/board/board_spec.h"

namespace robosim::project {

/// The board of an FQBN, VENDOR:ARCHITECTURE:BOARD[:KEY=VALUE,…], or null. An option that it leaves out has
/// the value that Arduino has for it; one that our boards do not differ in may have any, but cpu=…, which
/// must name their chip ("atmega328old").
const BoardSpec* board_of_fqbn(const std::string& fqbn);

/// A board with the chip that avr-gcc calls `chip` ("atmega328p", "atmega328"), and the clock that an FQBN of
/// another vendor's board may name ("clock=8MHz_internal"), or null.
const BoardSpec* board_with_chip(const std::string& chip, const std::string& fqbn);

/// The board of PlatformIO's id ("nanoatmega328"), or null.
const BoardSpec* board_of_platformio(const std::string& id);

/// How the tools write the boards that there are: "arduino:avr:uno, …" and "uno, …".
std::string all_fqbns();
std::string all_platformio_ids();

}  // namespace robosim::project
