// What a simulation comes to, in the units and words of the runner protocol.
#pragma once

#include <array>

#include "sim/robot/describe.h"
#include "sim/run/simulation.h"
#include "sim/wire/messages.h"

namespace robosim::runner {

inline double seconds(SimTime t) { return static_cast<double>(t) * 1e-9; }

wire::Started to_wire(const run::Beginning& beginning);
wire::Sample to_wire(const run::Sample& sample);
/// The same into one that was there before, whose memory serves again. Its robot's number stays.
void to_wire(const run::Sample& sample, wire::Sample& to);
/// What wire::BatchWriter::add_sample() asks for.
std::array<double, 10> numbers_of(const run::Sample& sample);
wire::Paused to_wire(const run::State& state, const run::Sample& sample);
/// Without what the request and its files were.
wire::RunResult to_wire(const judge::Outcome& outcome);
wire::RobotInfo to_wire(const robot::Summary& robot);

}  // namespace robosim::runner
