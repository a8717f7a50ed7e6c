// Makes results for runs whose process was killed, or ended without sending a result.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hal/board/sim_time.h"
#include "sim/base/child.h"
#include "sim/result/run_result.h"
#include "sim/wire/messages.h"
#include "sim/wire/run_request.h"

namespace robosim::runner {

/// Exit statuses of a process whose watchdog has detected an endless loop: after loading, and during loading.
constexpr int kWatchdogStatus = 99, kLoadingStatus = 98;

constexpr const char* kLoops = "it loops without end, and simulated time does not advance";
constexpr const char* kNeverLoads = "loading it takes too much processor time";

/// Returns the number of the robot whose sketch ended the process. `suspects` are the robots whose sketches
/// run as native code. `acting` is the last robot number that the process recorded. Throws InputError if a
/// sketch has overwritten `acting` and there are several suspects. Throws std::runtime_error if a chip was
/// being emulated: the emulator has a fault, or a sketch wrote to invalid memory.
std::size_t guilty_robot(const wire::RunRequest& request, const std::vector<std::size_t>& suspects,
                         int acting);

/// Returns the result for a crash of robot `guilty` at `time`. `cause` is a clause, such as kLoops. `check`
/// is the value of result::Crash::check.
result::RunResult result_of_crash(const wire::RunRequest& request, const std::string& cause,
                                  const std::string& check, std::size_t guilty, SimTime time);
/// Returns the answer for a process that ran out of memory. If the machine limits the runner's memory, the
/// answer is an error, not a crash.
wire::Answer answer_without_memory(const wire::RunRequest& request, std::size_t guilty, SimTime time);

/// Returns a clause that describes how a process ended.
std::string cause_of(const Ending& ending);

}  // namespace robosim::runner
