// Extracts the words that a sketch may understand from its source.
#pragma once

#include <string>
#include <vector>

namespace robosim::campaign {

/// Returns whether the source reads input, from a serial port or another stream.
bool reads_input(std::string source);
/// Returns whether the source uses the EEPROM.
bool uses_eeprom(const std::string& source);
/// Adds the source's quoted texts that are not printed.
void add_words(const std::string& source, std::vector<std::string>& words);
/// Returns whether a word fits in a line of a script, and is not longer than usual commands.
bool may_be_sent(const std::string& word);

}  // namespace robosim::campaign
