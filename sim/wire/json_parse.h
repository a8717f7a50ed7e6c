// Parses JSON. For JSON in the style of the protocol's programs, this takes a third of the instructions of
// nlohmann's parser. Include only in .cpp files.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace robosim::wire {

/// Parses like nlohmann::json::parse. Returns a discarded value if `text` is not JSON or exceeds the limits
/// in sim/base/json_limits.h.
nlohmann::json parsed_json(std::string_view text);

}  // namespace robosim::wire
