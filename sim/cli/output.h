// Standard output, with its errors noticed.
#pragma once

#include <string_view>

namespace robosim::cli {

/// Writes and flushes. Throws InputError if that fails (a full disk).
void print(std::string_view text);

}  // namespace robosim::cli
