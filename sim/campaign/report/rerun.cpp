#include "sim/campaign/report/rerun.h"

#include <algorithm>
#include <utility>

#include "sim/campaign/rerun/recorded.h"
#include "sim/record/record_page.h"

namespace robosim::campaign {

RecordingExtract extract_of(const record::Recording& recording) {
  const record::RecordingHeader& header = recording.header();
  RecordingExtract extract{header.map, header.map_text, header.floor, {}};
  for (std::size_t robot = 0; robot < header.robot_count(); ++robot) {
    const auto samples = recording.stream("samples", robot);
    if (samples.size() < 3) continue;
    for (const record::LineEvent& event : header.of(robot).line) {
      if (!event.left) continue;
      const auto at = std::lower_bound(samples[0].begin(), samples[0].end(), static_cast<double>(event.t_us));
      const auto row = static_cast<std::size_t>(at - samples[0].begin());
      if (row < samples[0].size()) extract.left_mm.push_back({samples[1][row], samples[2][row]});
    }
  }
  return extract;
}

client::Runner& Rerun::runner(const std::string& target) {
  return runners_.try_emplace(target, target).first->second;
}

std::optional<std::string> Rerun::operator()(launch::Launch launch, const std::string& trace_hash) {
  record::RecRecorder("").ask(launch.request);
  launch::Chosen chosen = choose(launch);
  client::Runner& by = runner(chosen.target);
  const launch::Prepared prepared = launcher_.prepare(
      launch, std::move(chosen), [&](const std::string& name) { return by.describe_robot(name); },
      by.hello());
  return run(by, recorded(prepared, by.hello().version), trace_hash);
}

std::optional<std::string> Rerun::operator()(launch::Fleet fleet, wire::RunRequest common,
                                             const std::string& trace_hash) {
  record::RecRecorder("").ask(common);
  common.script.clear();  // each robot has its own script
  launch::ChosenFleet chosen = choose(fleet);
  client::Runner& by = runner(chosen.runner);
  const launch::PreparedFleet prepared = launch::prepare(
      launcher_, fleet, std::move(chosen), common,
      [&](const std::string& name) { return by.describe_robot(name); }, by.hello());
  return run(by, recorded(fleet, prepared, by.hello().version), trace_hash);
}

std::optional<std::string> Rerun::run(client::Runner& by, const record::RecordedRun& what,
                                      const std::string& trace_hash) {
  record::Gatherer gatherer(std::make_unique<record::Deflater>());
  gatherer.begin(what);
  const result::RunResult result =
      by.run(what.request, [&](const wire::Event& event) { gatherer.add(event); });
  if (launch::whole_of(result, what.request).trace_hash != trace_hash) return std::nullopt;
  return gatherer.encoded(result);
}

}  // namespace robosim::campaign
