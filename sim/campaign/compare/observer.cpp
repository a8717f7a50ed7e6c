#include "sim/campaign/compare/observer.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/wire/agent_of.h"

namespace robosim::campaign {
namespace {

// A robot is off the line if two distances are too large. One is from the axle to the line with square
// corners. The other is from the sensors' midpoint to the line with its real bends.
constexpr double kOff_cells = 0.75, kOff_mm = 50.0;

}  // namespace

Observer::Observer(const wire::RunRequest& request) : map_(map::read_map(request.map)) {
  const auto add = [&](const std::string& start) {
    places_.emplace_back(map_, start.empty() ? map::default_start(map_) : map::parse_start(map_, start));
  };
  add(request.start);
  for (const wire::AgentRequest& agent : request.agents) add(agent.start);
}

std::string Observer::place_of(std::size_t robot, const wire::Sample& sample) const {
  const Vec2 axle{1e-3 * sample.x_mm, 1e-3 * sample.y_mm};
  const map::Places& places = places_[robot];
  const bool off = places.cells_off(axle) > kOff_cells && sample.cross_track_mm > kOff_mm;
  return off ? analysis::kOffTheLine : places.at(axle);
}

analysis::HistoryRecorder Observer::recorder_of(const TargetRun& target_run, std::size_t robot) const {
  return {target_run.target, [this, robot](const wire::Sample& sample) { return place_of(robot, sample); }};
}

wire::RunRequest Observer::request_of(const TargetRun& target_run, std::uint64_t seed) {
  wire::RunRequest request = target_run.run.request;
  request.seed = seed;
  request.samples_every_ns = analysis::HistoryRecorder::kSampleEvery_ns;
  request.serial = request.notes = true;
  return request;
}

bool Observer::is_of(const wire::Event& event, std::size_t robot) {
  return static_cast<std::size_t>(wire::agent_of(event)) == robot;
}

analysis::History Observer::run(TargetRun& target_run, const ObservedRobot& observed,
                                const ClockOffset& off) const {
  wire::RunRequest request = request_of(target_run, observed.seed);
  for (std::size_t robot = 0; off.ppm != 0 && robot < robots(); ++robot)
    TargetRun::script(request, robot) +=
        fmt::format("\nat {}ms fault clock drift {}ppm\n", off.from_ns / 1'000'000,
                    robot == observed.robot ? off.ppm : -off.ppm);
  TargetRun::late(request, observed.robot) = observed.late;
  request.for_ns = std::min(request.for_ns, observed.until_ns / 1'000'000 * 1'000'000);
  analysis::HistoryRecorder recorder = recorder_of(target_run, observed.robot);
  const Results results = launch::results_of(target_run.runner.run(request, [&](const wire::Event& event) {
    if (is_of(event, observed.robot)) recorder.add(event);
  }));
  return recorder.finish(results[observed.robot]);
}

}  // namespace robosim::campaign
