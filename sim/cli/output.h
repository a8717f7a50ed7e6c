// Standard output, with its errors checked.
#pragma once

#include <string_view>

namespace robosim::cli {

/// Writes and flushes. Throws InputError if that fails (a full disk).
void print(std::string_view text);

}  // namespace robosim::cli
