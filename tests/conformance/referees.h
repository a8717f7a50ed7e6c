// Runs a program on Robosim's emulated AVR and, for comparison, on other emulators. No shipped program links
// the other emulators.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "tests/conformance/program.h"

namespace robosim::conformance {

/// Runs a program on Robosim's emulated AVR.
Report run_on_ours(const Program& program, std::span<const std::uint8_t> flash);
/// Runs a program on unchanged libsimavr, by avr_run().
Report run_on_simavr(const Program& program, std::span<const std::uint8_t> flash);
/// Runs a program for the ATmega328P on avr8js, by node and avr8js.mjs. Returns nothing if node or avr8js is
/// missing. $ROBOSIM_AVR8JS is the folder in which `npm install avr8js` was run.
std::optional<Report> run_on_avr8js(const Program& program, std::span<const std::uint8_t> flash);

}  // namespace robosim::conformance
