// Other emulators, which run the same programs for comparison. No shipped program links them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/conformance/program.h"

namespace robosim::conformance {

/// A program's report, and whether the program reached its end.
struct Report {
  std::vector<std::uint8_t> bytes;
  bool ended = false;
};

bool is_right(const Program& program, const Report& report);

/// Runs a program on Robosim's own core.
Report run_on_ours(const Program& program, std::span<const std::uint8_t> flash);
/// Runs a program on unchanged libsimavr, by avr_run().
Report run_on_simavr(const Program& program, std::span<const std::uint8_t> flash);
/// Runs a program for the ATmega328P on avr8js, by node and avr8js.mjs. Returns nothing if either is missing.
/// $ROBOSIM_AVR8JS is the folder in which `npm install avr8js` was run.
std::optional<Report> run_on_avr8js(const Program& program, std::span<const std::uint8_t> flash);

}  // namespace robosim::conformance
