// JSON as the ends of the protocol write it, read in a third of the instructions that nlohmann's parser
// takes. For .cpp files.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace robosim::wire {

/// As nlohmann::json::parse has it, discarded if `text` is not JSON or exceeds sim/base/json_limits.h.
nlohmann::json parsed_json(std::string_view text);

}  // namespace robosim::wire
