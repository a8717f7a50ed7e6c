// Reads and writes lines at the runner's end of the pipes to its client.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <string_view>

namespace robosim::runner {

class SandboxProxy;
/// From now on, passes all lines in both directions through `proxy`, which must outlive all calls of the
/// functions below.
void route_through(const SandboxProxy& proxy);

/// Writes one line, with its line feed. Ends the process if the client has disconnected.
void write_line(const std::string& line);
/// Writes a line, and bytes after it.
void write_batch(std::string_view line, std::string_view bytes);
/// Returns the next line of standard input, without its line feed. Returns nothing at the end of input, or
/// when a signal handler has set `interrupted`. A fork continues where its parent stopped reading.
std::optional<std::string> read_line(const std::atomic<bool>* interrupted = nullptr);
/// Removes and returns input that is not a complete line yet.
std::string take_unread();

}  // namespace robosim::runner
