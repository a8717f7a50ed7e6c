// Results of runs whose process ended without a result, or was killed.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hal/board/sim_time.h"
#include "sim/base/child.h"
#include "sim/wire/messages.h"
#include "sim/wire/run_request.h"
#include "sim/wire/run_result.h"

namespace robosim::runner {

/// Exit status of a process whose watchdog has detected an endless loop.
constexpr int kWatchdogStatus = 99;

constexpr const char* kLoops = "it loops without end inside a library function";
constexpr const char* kNeverLoads = "it loops without end while it is loaded";

/// Returns the number of the robot whose sketch took the process down. `suspects`: the robots whose sketches
/// are native code; `acting`: the last number that the process recorded. Throws std::runtime_error if it was
/// not a sketch. Then the emulator has a fault, or another sketch wrote to invalid memory.
std::size_t guilty_robot(const wire::RunRequest& request, const std::vector<std::size_t>& suspects,
                         int acting);

/// Returns the result for a crash of robot `guilty` by `cause`, a clause, at `time`. `check` as in Crash.
wire::RunResult result_of_crash(const wire::RunRequest& request, const std::string& cause,
                                const std::string& check, std::size_t guilty, SimTime time);
/// Returns the answer for a process that ran out of memory. The machine is to blame if it allows less than a
/// sketch may have.
wire::Answer answer_without_memory(const wire::RunRequest& request, std::size_t guilty, SimTime time);

/// Returns the clause for such an end of a process.
std::string cause_of(const Ending& ending);

}  // namespace robosim::runner
