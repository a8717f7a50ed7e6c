// The command line of `robosim sweep`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Parses `words`, after "sweep". Throws InputError.
Command parse_sweep(const std::vector<std::string>& words);

/// Parses the value of --seeds, "17" or "1..100". Throws InputError.
void read_seeds(const std::string& text, std::uint64_t& first, std::uint64_t& last);

/// Accepts "host,avr" as well as "host avr".
std::vector<std::string> split_at_commas(const std::vector<std::string>& words);

/// Parses the value of --jobs; empty = one for each core. Throws InputError.
std::size_t number_of_jobs(const std::string& text);

}  // namespace robosim::cli
