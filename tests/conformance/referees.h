// Other emulators, which run the same programs for comparison. Nothing that is shipped links them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/conformance/program.h"

namespace robosim::conformance {

/// A program's report, and whether it reached its end.
struct Report {
  std::vector<std::uint8_t> bytes;
  bool ended = false;
};

bool is_right(const Program& program, const Report& report);

/// On the core of our own.
Report run_on_ours(const Program& program, std::span<const std::uint8_t> flash);
/// On libsimavr as it comes, by avr_run().
Report run_on_simavr(const Program& program, std::span<const std::uint8_t> flash);
/// On avr8js, which is an ATmega328P, by node and avr8js.mjs; nothing where either is missing
/// ($ROBOSIM_AVR8JS is the folder in which `npm install avr8js` was run).
std::optional<Report> run_on_avr8js(const Program& program, std::span<const std::uint8_t> flash);

}  // namespace robosim::conformance
