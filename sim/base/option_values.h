// Reads the values of options, from a command line or a file. All errors have the form
// "--seed: expected ALLOWED, got “x”", and are thrown as InputError.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace robosim {

constexpr std::uint64_t kMostSeed = std::numeric_limits<std::uint64_t>::max();

/// Throws InputError: "--seed: expected `allowed`, got “x”`hint`".
[[noreturn]] void refuse_value(const char* option, const std::string& value, const std::string& allowed,
                               const std::string& hint = "");

/// Reads a time above 0 with its unit, as in "60s". Returns nanoseconds.
std::int64_t simulated_time(const char* option, const std::string& text);
/// Reads a whole number from `least` to `most`.
std::uint64_t whole_number(const char* option, const std::string& text, std::uint64_t least,
                           std::uint64_t most);
std::uint64_t seed_number(const std::string& text);
/// Reads the value of --seeds, "17" or "1..100".
void read_seeds(const std::string& text, std::uint64_t& first, std::uint64_t& last);
/// Reads the value of --jobs. An empty text means one job for each processor core.
std::size_t number_of_jobs(const std::string& text);
/// Splits each word at its commas: "host,avr" gives two words.
std::vector<std::string> split_at_commas(const std::vector<std::string>& words);

void check_choice(const char* option, const std::string& value, const std::vector<std::string>& allowed);
void check_profile(const std::string& value);

}  // namespace robosim
