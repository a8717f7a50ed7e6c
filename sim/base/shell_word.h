// Quotes commands that users copy into a shell.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace robosim {

/// Returns the text as one shell word, quoted only where necessary.
std::string shell_word(const std::string& text);

/// Splits a command that was made of shell_word()s; returns nothing if a quote in it is not closed.
std::optional<std::vector<std::string>> shell_words(const std::string& command);

}  // namespace robosim
