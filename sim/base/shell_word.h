// Commands that users copy into a shell.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace robosim {

/// The text as one word for a shell, quoted only where necessary.
std::string shell_word(const std::string& text);

/// The words of a command that was made of shell_word()s; nothing if a quote in it is not closed.
std::optional<std::vector<std::string>> shell_words(const std::string& command);

}  // namespace robosim
