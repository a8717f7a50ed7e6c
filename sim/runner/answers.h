// Answers and events of the runner protocol, as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "sim/robot/describe.h"
#include "sim/run/simulation.h"

namespace robosim::runner {

/// Keys keep the order in which docs/runner-protocol.md lists them.
using Json = nlohmann::ordered_json;

Json to_json(const run::Beginning& beginning);
Json to_json(const run::Sample& sample);
Json to_json(const run::State& state, const run::Sample& sample);
Json to_json(const judge::Outcome& outcome);
Json to_json(const robot::Summary& robot);

/// One line of text without its newline. Bytes that are no UTF-8 become U+FFFD.
std::string to_line(const Json& json);

}  // namespace robosim::runner
