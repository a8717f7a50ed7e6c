// What a sketch's source says of the words that it may understand.
#pragma once

#include <string>
#include <vector>

namespace robosim::cli {

/// Whether the source reads what is sent to it, by a serial port or another stream.
bool listens(std::string source);
/// Whether it uses the EEPROM.
bool keeps(const std::string& source);
/// Adds what stands between quotes and is not printed.
void add_words(const std::string& source, std::vector<std::string>& words);
/// Whether it fits a line of a script, and is no longer than commands are.
bool may_be_sent(const std::string& word);

}  // namespace robosim::cli
