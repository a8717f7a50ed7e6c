// Converts results of a simulation to the units and words of the runner protocol.
#pragma once

#include <array>

#include "sim/robot/describe.h"
#include "sim/run/simulation.h"
#include "sim/wire/messages.h"

namespace robosim::runner {

inline double seconds(SimTime t) { return static_cast<double>(t) * 1e-9; }

wire::Started to_wire(const run::Beginning& beginning);
wire::Sample to_wire(const run::Sample& sample);
/// Writes the converted sample into `to`, and reuses the memory of `to`. Does not change `to.agent`.
void to_wire(const run::Sample& sample, wire::Sample& to);
/// Returns the numbers for wire::BatchWriter::add_sample().
std::array<double, 10> numbers_of(const run::Sample& sample);
wire::Paused to_wire(const run::State& state, const run::Sample& sample);
/// Converts an outcome. Does not set the fields about the request and its files.
result::RunResult to_wire(const judge::Outcome& outcome);
wire::RobotInfo to_wire(const robot::Summary& robot);

}  // namespace robosim::runner
