#include "sim/runner/requested_run.h"

#include <numeric>
#include <utility>

#include "sim/judge/goal.h"
#include "sim/runner/answers.h"
#include "sim/runner/known_hash.h"
#include "sim/scenario/scenario.h"

namespace robosim::runner {

Inputs inputs_of(const wire::RunRequest& request, const robot::Description& robot) {
  return {grid::sha256_of_map(request.map), robot.sha256, known_sha256(request.image)};
}

wire::RunResult result_of(const judge::Outcome& outcome, const wire::RunRequest& request,
                          const Inputs& inputs) {
  wire::RunResult result = to_wire(outcome);
  result.for_s = static_cast<double>(request.for_ns) * 1e-9;
  result.seed = request.seed;
  result.profile = to_string(profile_of(request.profile));
  result.map_sha256 = inputs.map_sha256;
  result.robot_sha256 = inputs.robot_sha256;
  result.image_sha256 = inputs.image_sha256;
  return result;
}

RequestedRun::RequestedRun(const MakeExecutor& make, const wire::RunRequest& request, Tell tell)
    : request_(request),
      map_(grid::read_map(request.map)),
      robot_(robot::load_description(request.robot)),
      executor_(make(*robot_.board, request.image)),
      inputs_(inputs_of(request, robot_)),
      narrator_(request, *robot_.board, *executor_, std::move(tell)) {
  if (request.clock_ns > 0) executor_->set_clock_start(request.clock_ns);
  if (!request.counters.empty()) executor_->count_lines();
  if (request.source_ns) executor_->trace_bytes(request.source_ns->first, request.source_ns->second);

  setup_.map = &map_;
  run::AgentSetup& agent = setup_.agents.emplace_back();
  agent.robot = &robot_;
  agent.executor = executor_.get();
  agent.listener = &narrator_;
  if (!request.start.empty()) agent.start = grid::parse_start(map_, request.start);
  if (!request.goal.empty()) agent.goal = judge::parse_goal(request.goal);
  agent.scenario = scenario::parse_scenario(request.script, request.script_file);
  setup_.limit = request.for_ns;
  setup_.seed = request.seed;
  setup_.profile = profile_of(request.profile);
  setup_.samples_every = std::gcd(request.samples_every_ns, request.columns_every_ns);
}

wire::RunResult RequestedRun::go() {
  const judge::Outcome outcome = run::simulate(setup_).front();
  flush(outcome.time);
  return result_of(outcome, request_, inputs_);
}

}  // namespace robosim::runner
