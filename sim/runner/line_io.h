// The runner's end of the pipe: reads and writes lines.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <string_view>

namespace robosim::runner {

class SandboxProxy;
/// Passes all lines through this from now on, in both directions. It must outlive the process's use of them.
void route_through(const SandboxProxy& proxy);

/// Writes one line (with its line feed); ends the process if the client has gone.
void write_line(const std::string& line);
/// Writes a line and the bytes after it.
void write_batch(std::string_view line, std::string_view bytes);
/// Returns the next line of standard input, without its line feed. Returns nothing at its end, or when a
/// signal handler has set `interrupted`. A fork continues reading where its parent was.
std::optional<std::string> read_line(const std::atomic<bool>* interrupted = nullptr);
/// Returns input that is not a complete line yet.
std::string take_unread();

}  // namespace robosim::runner
