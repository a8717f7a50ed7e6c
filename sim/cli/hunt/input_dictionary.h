// Extracts the words that a sketch may understand from its source.
#pragma once

#include <string>
#include <vector>

namespace robosim::cli {

/// Returns whether the source reads input, from a serial port or another stream.
bool reads_input(std::string source);
/// Returns whether it uses the EEPROM.
bool uses_eeprom(const std::string& source);
/// Adds quoted texts that are not printed.
void add_words(const std::string& source, std::vector<std::string>& words);
/// Returns whether it fits in a line of a script, and is no longer than commands usually are.
bool may_be_sent(const std::string& word);

}  // namespace robosim::cli
