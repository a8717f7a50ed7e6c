#include "sim/cli/report/made_again.h"

#include <algorithm>
#include <utility>

#include "sim/cli/launching.h"
#include "sim/record/record_page.h"

namespace robosim::cli {
std::vector<std::array<double, 2>> places_left(const std::string& bytes) {
  const record::Recording recording = record::Recording::decode(bytes, "the recording");
  const auto samples = recording.stream("samples");
  std::vector<std::array<double, 2>> places;
  if (samples.size() < 3) return places;
  for (const record::LineEvent& event : recording.header().line) {
    if (!event.left) continue;
    const auto at = std::lower_bound(samples[0].begin(), samples[0].end(), static_cast<double>(event.t_us));
    const auto row = static_cast<std::size_t>(at - samples[0].begin());
    if (row < samples[0].size()) places.push_back({samples[1][row], samples[2][row]});
  }
  return places;
}

MakeAgain::MakeAgain(const RunArguments& each)
    : launch_(launch_of(each)), progress_(true), launcher_(listener_of(progress_, {false, false})) {}

client::Runner& MakeAgain::runner(const std::string& target) {
  return runners_.try_emplace(target, target).first->second;
}

std::optional<MadeAgain> MakeAgain::operator()(const SweptRun& run) {
  launch::Launch launch = launch_;
  launch.sketch = run.sketch;
  launch.map = run.map;
  launch.robot = run.robot;
  launch.target = run.target;
  launch.request.seed = run.seed;
  record::RecRecorder("").ask(launch.request);
  client::Runner& by = runner(run.target);
  const launch::Prepared prepared = launcher_.prepare(
      launch, choose(launch), [&](const std::string& name) { return by.describe_robot(name); }, by.hello());
  record::Gatherer gatherer;
  gatherer.begin({by.hello().version, launch::title_of(prepared.sketch), prepared.map.name,
                  prepared.robot.name, prepared.target, prepared.robot_info, prepared.request});
  const wire::RunResult result =
      by.run(prepared.request, [&](const wire::Event& event) { gatherer.add(event); });
  progress_.clear();
  if (result.trace_hash != run.trace_hash) return std::nullopt;
  MadeAgain again;
  again.recording = gatherer.encoded(result);
  again.left_mm = places_left(again.recording);
  again.floor = record::Recording::decode(again.recording, "the recording").header().floor;
  return again;
}

}  // namespace robosim::cli
