// Quotes commands that users copy into a shell.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace robosim {

/// Returns a text as one shell word, quoted only if necessary.
std::string shell_word(const std::string& text);

/// Splits a command that was composed of shell_word() results; returns nothing if a quote is not closed.
std::optional<std::vector<std::string>> shell_words(const std::string& command);

}  // namespace robosim
