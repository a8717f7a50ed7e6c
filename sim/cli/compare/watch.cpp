#include "sim/cli/compare/watch.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/wire/agent_of.h"

namespace robosim::cli {
namespace {

// The robot's axle is this far from the square line, and the middle of its sensors from the line with its
// bends.
constexpr double kOff_cells = 0.75, kOff_mm = 50.0;

}  // namespace

Watch::Watch(const wire::RunRequest& request) : map_(grid::read_map(request.map)) {
  const auto add = [&](const std::string& start) {
    places_.emplace_back(map_, start.empty() ? grid::default_start(map_) : grid::parse_start(map_, start));
  };
  add(request.start);
  for (const wire::AgentRequest& agent : request.agents) add(agent.start);
}

std::string Watch::place_of(std::size_t robot, const wire::Sample& sample) const {
  const Vec2 axle{1e-3 * sample.x_mm, 1e-3 * sample.y_mm};
  const grid::Places& places = places_[robot];
  const bool off = places.cells_off(axle) > kOff_cells && sample.cross_track_mm > kOff_mm;
  return off ? analysis::kOffTheLine : places.at(axle);
}

analysis::HistoryRecorder Watch::recorder_of(const Lane& lane, std::size_t robot) const {
  return {lane.target, [this, robot](const wire::Sample& sample) { return place_of(robot, sample); }};
}

wire::RunRequest Watch::request_of(const Lane& lane, std::uint64_t seed) {
  wire::RunRequest request = lane.run.request;
  request.seed = seed;
  request.samples_every_ns = analysis::HistoryRecorder::kSampleEvery_ns;
  request.serial = request.notes = true;
  return request;
}

bool Watch::is_of(const wire::Event& event, std::size_t robot) {
  return static_cast<std::size_t>(wire::agent_of(event)) == robot;
}

analysis::History Watch::run(Lane& lane, const Watched& watched, const ClockOff& off) const {
  wire::RunRequest request = request_of(lane, watched.seed);
  for (std::size_t robot = 0; off.ppm != 0 && robot < robots(); ++robot)
    Lane::script(request, robot) +=
        fmt::format("\nat {}ms fault clock drift {}ppm\n", off.from_ns / 1'000'000,
                    robot == watched.robot ? off.ppm : -off.ppm);
  Lane::late(request, watched.robot) = watched.late;
  request.for_ns = std::min(request.for_ns, watched.until_ns / 1'000'000 * 1'000'000);
  analysis::HistoryRecorder recorder = recorder_of(lane, watched.robot);
  const Results results = launch::results_of(lane.runner.run(request, [&](const wire::Event& event) {
    if (is_of(event, watched.robot)) recorder.add(event);
  }));
  return recorder.finish(results[watched.robot]);
}

}  // namespace robosim::cli
