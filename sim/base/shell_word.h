// Commands that users copy into a shell.
#pragma once

#include <string>

namespace robosim::cli {

/// The text as a shell takes it for one word; in quotes only where it must be.
std::string shell_word(const std::string& text);

}  // namespace robosim::cli
