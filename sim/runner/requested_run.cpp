#include "sim/runner/requested_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "sim/judge/goal.h"
#include "sim/robot/robot.h"
#include "sim/run/scenario/scenario.h"
#include "sim/runner/answers.h"
#include "sim/runner/debugged_run.h"
#include "sim/runner/known_hash.h"
#include "sim/runner/verdict_trace.h"

namespace robosim::runner {
namespace {

void check_several(const wire::RunRequest& request) {
  if (request.agents.empty()) return;
  if (request.agents.size() >= result::kMostAgents)
    throw InputError(fmt::format("too many robots: expected at most {}, got {}", result::kMostAgents,
                                 request.agents.size() + 1));
  if (request.name.empty())
    throw InputError("the first robot requires a name, because there are several robots");
  std::set<std::string> names;
  for (const wire::AgentRequest& agent : agents_of(request))
    if (!names.insert(agent.name).second)
      throw InputError(
          fmt::format("two robots are named {}: expected a different name for each robot", agent.name));
  if (request.gdb_port > 0)
    throw InputError("a debugger halts only one robot's chip; debug that robot in a run of its own");
  if (!request.counters.empty()) throw InputError("counting lines requires a run of one robot");
}

void check_why(const wire::RunRequest& request) {
  if (!request.why) return;
  if (!request.agents.empty()) throw InputError("tracing the cause of a verdict requires a run of one robot");
  if (request.interactive || request.gdb_port > 0)
    throw InputError("tracing the cause of a verdict requires a run without a driver or debugger");
}

run::Mission errand_of(const wire::AgentRequest& asked, const map::Map& map) {
  run::Mission mission;
  if (!asked.start.empty()) mission.start = map::parse_start(map, asked.start);
  if (!asked.goal.empty()) mission.goal = judge::parse_goal(asked.goal);
  return mission;
}

/// Throws `error` again, with the name of the robot in its message.
[[noreturn]] void blame(const std::string& robot, const InputError& error) {
  throw InputError(error.place(), fmt::format("robot {}: {}", robot, error.message()));
}

}  // namespace

std::vector<wire::AgentRequest> agents_of(const wire::RunRequest& request) {
  std::vector<wire::AgentRequest> all = {{request.name, request.target, request.image, request.robot,
                                          request.start, request.goal, request.clock_ns, request.script,
                                          request.script_file, request.late}};
  all.insert(all.end(), request.agents.begin(), request.agents.end());
  return all;
}

map::Draw draw_of(const wire::RunRequest& request) { return {request.seed, profile_of(request.profile)}; }

ReadMap::ReadMap(const std::filesystem::path& file, map::Draw draw)
    : map(map::read_map(file, draw)), sha256(map::sha256_of(map)) {}

std::vector<run::Mission> missions_of(const wire::RunRequest& request, const map::Map& map) {
  std::vector<run::Mission> missions;
  for (const wire::AgentRequest& agent : agents_of(request)) missions.push_back(errand_of(agent, map));
  return missions;
}

Inputs inputs_of(const std::string& map_sha256, const std::string& image, const robot::Description& robot) {
  return {map_sha256, robot.sha256, known_sha256(image)};
}

result::RunResult result_of(const judge::Outcome& outcome, const wire::RunRequest& request,
                            const Inputs& inputs) {
  result::RunResult result = to_wire(outcome);
  result.for_s = static_cast<double>(request.for_ns) * 1e-9;
  result.seed = request.seed;
  result.profile = to_string(profile_of(request.profile));
  result.map_sha256 = inputs.map_sha256;
  result.robot_sha256 = inputs.robot_sha256;
  result.image_sha256 = inputs.image_sha256;
  return result;
}

RequestedRun::RequestedRun(const MakeExecutor& make, const wire::RunRequest& request, Tell tell,
                           SharedBatches batches, Robots robots, std::shared_ptr<ReadMap> map)
    : request_(request),
      map_(map ? std::move(map) : std::make_shared<ReadMap>(request.map, draw_of(request))),
      robots_(std::move(robots)) {
  check_several(request);
  check_why(request);
  if (request.batches) {
    batcher_ = std::make_unique<EventBatcher>(std::move(tell), std::move(batches));
    tell = [batcher = batcher_.get()](wire::Event event) { batcher->tell(std::move(event)); };
  }
  for (wire::AgentRequest& asked : agents_of(request)) {
    try {
      add(make, std::move(asked), tell);
    } catch (const InputError& error) {
      if (request.agents.empty()) throw;
      blame(members_.back().asked.name, error);
    }
  }
  setup_.map = &map_->map;
  setup_.prepared_map = &map_->prepared_map;
  setup_.limit = request.for_ns;
  setup_.seed = request.seed;
  setup_.profile = profile_of(request.profile);
  setup_.detect = request.detect;
  setup_.samples_every = std::gcd(request.samples_every_ns, request.columns_every_ns);
}

const robot::Description& RequestedRun::robot_named(const std::string& name) {
  std::shared_ptr<const robot::Description>& known = robots_[name];
  if (!known) known = std::make_shared<const robot::Description>(robot::load_description(name));
  return *known;
}

void RequestedRun::add(const MakeExecutor& make, wire::AgentRequest asked, const Tell& tell) {
  const auto number = static_cast<int>(members_.size());
  Member& member = members_.emplace_back();
  member.asked = std::move(asked);
  const wire::AgentRequest& agent = member.asked;
  member.robot = &robot_named(agent.robot);
  const BoardSpec& board = *member.robot->board;
  member.executor = make(agent.target, board, agent.image);
  member.inputs = inputs_of(map_->sha256, agent.image, *member.robot);
  member.encoder =
      std::make_unique<EventEncoder>(request_, number, board, *member.executor, tell, batcher_.get());
  if (agent.clock_ns > 0)
    exec::chip_of(
        *member.executor,
        "setting the clock requires an emulated chip; on the host, millis() is wider and never wraps")
        .set_clock_start(agent.clock_ns);
  if (!agent.late.empty()) {
    exec::HostAccess* const host = member.executor->host_access();
    if (!host) throw InputError("delaying a sketch requires the target host");
    host->set_lateness(agent.late);
  }
  if (!request_.counters.empty()) member.executor->count_lines();
  if (exec::ChipAccess* const chip = member.executor->chip_access(); chip && request_.source_ns)
    chip->trace_bytes(request_.source_ns->first, request_.source_ns->second);

  run::AgentSetup& setup = setup_.agents.emplace_back();
  setup.robot = member.robot;
  setup.executor = member.executor.get();
  setup.listener = member.encoder.get();
  const run::Mission mission = errand_of(agent, map_->map);
  setup.start = mission.start;
  setup.goal = mission.goal;
  setup.scenario = scenario::parse_scenario(agent.script, agent.script_file);
}

void RequestedRun::flush(SimTime t) {
  for (const Member& member : members_) {
    member.encoder->flush_serial(t);
    member.encoder->flush_columns();
  }
  if (batcher_) batcher_->flush();
}

void RequestedRun::debug_with(exec::gdb::Server& server) {
  exec::chip_of(executor(), "attaching a debugger requires an emulated chip").debug_with(server);
  debugger_ = &server;
}

judge::Outcome RequestedRun::inquire() const {
  const robot::Description& robot = *members_.front().robot;
  return Inquiry(setup_, *robot.board, robot::wiring_of(robot)).go();
}

std::vector<judge::Outcome> RequestedRun::simulate() const {
  if (request_.why) return {inquire()};
  // A run with line counters, detectors or traced sources may not go back, because these would count some
  // ticks twice. A run that a client drives may not go back either, because the client cannot go back.
  const bool may_go_back =
      !request_.interactive && !request_.detect && request_.counters.empty() && !request_.source_ns;
  if (debugger_ && may_go_back) return {DebuggedRun(setup_, *debugger_).go()};
  const auto name = [&](int number) { return members_[static_cast<std::size_t>(number)].asked.name; };
  try {
    return run::simulate(setup_);
  } catch (const run::BadAgent& error) {
    if (error.other < 0) blame(name(error.agent), error);
    throw InputError(
        fmt::format("robot {} starts on top of robot {}: expected starts so far apart that the outlines do "
                    "not touch",
                    name(error.agent), name(error.other)));
  }
}

result::RunResult RequestedRun::go() { return result_of(simulate()); }

result::RunResult RequestedRun::result_of(const std::vector<judge::Outcome>& outcomes) {
  SimTime last = 0;
  for (const judge::Outcome& outcome : outcomes) last = std::max(last, outcome.time);
  flush(last);
  result::RunResult result = runner::result_of(outcomes.front(), request_, members_.front().inputs);
  for (std::size_t i = 1; i < outcomes.size(); ++i)
    result.others.push_back(runner::result_of(outcomes[i], request_, members_[i].inputs));
  return result;
}

}  // namespace robosim::runner
