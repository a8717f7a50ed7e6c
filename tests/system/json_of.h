// Parses the output of commands that ran with `--json`.
#pragma once

#include <nlohmann/json.hpp>

#include "tests/system/command.h"

namespace robosim::test {

/// Parses the output. Returns a discarded value if the output is not JSON.
inline nlohmann::json json_of(const Ended& ended) { return nlohmann::json::parse(ended.out, nullptr, false); }

}  // namespace robosim::test
