// The runner's end of the pipe: lines in and out.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <string_view>

namespace robosim::runner {

class Relay;
/// From now on lines go through this, in both directions. It must outlive the process's use of them.
void go_through(const Relay& relay);

/// Writes one line (with its line feed); ends the process if the client has gone.
void write_line(const std::string& line);
/// The same for a line and the bytes behind it.
void write_batch(std::string_view line, std::string_view bytes);
/// The next line of standard input, without its line feed; nothing at its end, or when a signal handler has
/// set `interrupted`. A fork goes on reading where its parent was.
std::optional<std::string> read_line(const std::atomic<bool>* interrupted = nullptr);
/// What has been read, and is no line yet.
std::string take_unread();

}  // namespace robosim::runner
