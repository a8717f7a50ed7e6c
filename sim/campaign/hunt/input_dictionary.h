// Extracts, from a sketch's source, words that the sketch may accept as input.
#pragma once

#include <string>
#include <vector>

namespace robosim::campaign {

/// Returns whether the source reads input, from a serial port or another stream.
bool reads_input(std::string source);
/// Returns whether the source uses the EEPROM.
bool uses_eeprom(const std::string& source);
/// Adds the string and character literals of the source, except those that the source prints.
void add_words(const std::string& source, std::vector<std::string>& words);
/// Returns whether a word fits in a line of a script, and is not longer than usual commands.
bool may_be_sent(const std::string& word);

}  // namespace robosim::campaign
