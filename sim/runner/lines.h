// The runner's end of the pipe: lines of JSON in and out.
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "sim/runner/answers.h"

namespace robosim::runner {

/// Writes one line; ends the process if the client has gone.
void write_line(const Json& json);
/// The next line of standard input, without its line feed; nothing at its end, or when a signal handler has
/// set `interrupted`. A fork goes on reading where its parent was.
std::optional<std::string> read_line(const std::atomic<bool>* interrupted = nullptr);

/// `{"id": …}`
Json with_id(const nlohmann::json& id);
void answer_error(const nlohmann::json& id, const char* kind, const std::string& message);

}  // namespace robosim::runner
