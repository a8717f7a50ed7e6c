// Commands that users copy into a shell.
#pragma once

#include <string>

namespace robosim {

/// The text as one word for a shell, quoted only where necessary.
std::string shell_word(const std::string& text);

}  // namespace robosim
