// Standard output, with its errors checked; standard error.
#pragma once

#include <string_view>

namespace robosim::cli {

/// Writes and flushes. Throws InputError if that fails (a full disk).
void print(std::string_view text);

/// Writes to standard error. Where that cannot be written there is nobody to tell: the exit status must do.
void complain(std::string_view text);

/// Puts /dev/null in the place of standard streams that are closed, or the next file that is opened would be
/// taken for one of them. Writing to such a standard output fails.
void open_standard_streams();

}  // namespace robosim::cli
