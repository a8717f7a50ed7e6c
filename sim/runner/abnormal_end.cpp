#include "sim/runner/abnormal_end.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <new>
#include <stdexcept>
#include <utility>

#include "sim/base/error.h"
#include "sim/base/system_error.h"
#include "sim/exec/host/confinement.h"
#include "sim/exec/host/host_fault.h"
#include "sim/judge/goal.h"
#include "sim/judge/outcome.h"
#include "sim/map/map.h"
#include "sim/robot/description.h"
#include "sim/runner/requested_run.h"

namespace robosim::runner {
namespace {

/// Returns the outcome of a robot whose run ended because the sketch of `other` ended the process.
judge::Outcome ended_by(const wire::AgentRequest& other) {
  judge::Outcome outcome;
  outcome.verdict = judge::Verdict::interrupted;
  outcome.why = fmt::format("The run ended when the sketch of {} ended its process.", other.name);
  return outcome;
}

}  // namespace

std::size_t guilty_robot(const wire::RunRequest& request, const std::vector<std::size_t>& suspects,
                         int acting) {
  if (request.agents.empty()) return 0;
  const auto found = std::find(suspects.begin(), suspects.end(), static_cast<std::size_t>(acting));
  if (found != suspects.end()) return *found;
  if (acting < 0 || acting > static_cast<int>(request.agents.size())) {  // a sketch has overwritten it
    if (suspects.size() == 1) return suspects[0];
    throw InputError(
        "one of the sketches on the host has ended the shared process and overwritten the record that names "
        "this sketch: run each sketch alone or on its chip");
  }
  throw std::runtime_error(fmt::format(
      "the run's process ended while the chip of robot {} was emulated; a sketch on the host that writes to "
      "invalid addresses can also cause this: run with --sanitize, or each sketch on its chip",
      agents_of(request)[static_cast<std::size_t>(acting)].name));
}

result::RunResult result_of_crash(const wire::RunRequest& request, const std::string& cause,
                                  const std::string& check, std::size_t guilty, SimTime time) {
  const std::vector<wire::AgentRequest> agents = agents_of(request);
  const std::string map_sha256 = map::sha256_of_map(request.map);
  std::vector<result::RunResult> results;
  for (std::size_t i = 0; i < agents.size(); ++i) {
    judge::Outcome outcome;
    if (i == guilty) {
      outcome.verdict = judge::Verdict::crashed;
      outcome.crash = exec::Crash{cause, {}};
      outcome.crash->check = check;
      outcome.why = "The sketch crashed: " + cause + ".";
    } else {
      outcome = ended_by(agents[guilty]);
    }
    outcome.time = std::max<SimTime>(time, 0);
    if (!agents[i].goal.empty()) outcome.goal = judge::parse_goal(agents[i].goal);
    const robot::Description robot = robot::load_description(agents[i].robot);
    results.push_back(result_of(outcome, request, inputs_of(map_sha256, agents[i].image, robot)));
  }
  result::RunResult result = std::move(results.front());
  result.others.assign(std::make_move_iterator(results.begin() + 1), std::make_move_iterator(results.end()));
  return result;
}

wire::Answer answer_without_memory(const wire::RunRequest& request, std::size_t guilty, SimTime time) {
  rlimit limit{};
  ::getrlimit(RLIMIT_AS, &limit);
  if (limit.rlim_cur != RLIM_INFINITY) return wire::ErrorAnswer{"tool", system_error_of(std::bad_alloc())};
  return result_of_crash(
      request,
      fmt::format("it took more than {} MB of memory, which is its limit", exec::kConfinedMemory >> 20),
      exec::kSandboxCheck, guilty, time);
}

std::string cause_of(const Ending& ending) {
  if (ending.status > exec::kSignalStatus && exec::why_not_confined().empty())
    return exec::signal_text(ending.status - exec::kSignalStatus);
  if (ending.signal > 0)
    return fmt::format("it ended its process with signal {} ({})", ending.signal, ::strsignal(ending.signal));
  if (ending.status == kWatchdogStatus) return kLoops;
  if (ending.status == kLoadingStatus) return kNeverLoads;
  return fmt::format("it ended its process with exit status {}", ending.status);
}

}  // namespace robosim::runner
