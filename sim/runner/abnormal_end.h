// Results of runs whose process ended without giving one, or had to be ended.
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

/// Exit status of a process whose watchdog has found that it loops.
constexpr int kWatchdogStatus = 99;

constexpr const char* kLoops = "it loops without end inside a library function";
constexpr const char* kNeverLoads = "it loops without end while it is loaded";

/// Returns the number of the robot whose sketch took the process down. `suspects`: the robots whose sketches
/// are code of this machine; `acting`: the number that the process has left. Throws std::runtime_error if it
/// was no sketch: what emulates a chip has a fault, or a sketch next to it wrote where it may not.
std::size_t guilty_robot(const wire::RunRequest& request, const std::vector<std::size_t>& suspects,
                         int acting);

/// The result where the sketch of robot `guilty` crashed by `cause`, a clause, at `time`. `check` as in
/// Crash.
wire::RunResult result_of_crash(const wire::RunRequest& request, const std::string& cause,
                                const std::string& check, std::size_t guilty, SimTime time);
/// The same of a process that had no memory left. That is the machine's fault where it allows less than a
/// sketch may have.
wire::Answer answer_without_memory(const wire::RunRequest& request, std::size_t guilty, SimTime time);

/// The clause for a process that has ended so.
std::string cause_of(const Ending& ending);

}  // namespace robosim::runner
