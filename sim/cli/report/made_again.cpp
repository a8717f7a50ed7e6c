#include "sim/cli/report/made_again.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "sim/cli/launching.h"
#include "sim/record/record_page.h"

namespace robosim::cli {
namespace {

// As sim/page/run.js has them.
constexpr double kLeft_s = 0.02;
constexpr double kSpread = 0.2, kBegins = 0.1;  // of what a sensor reads
constexpr double kAlways = 0.5;  // less than that a sensor that is always over the line never reads

struct Seen {
  std::vector<double> values;
  double from;  ///< more is line
};

}  // namespace

std::vector<std::array<double, 2>> places_left(const std::string& bytes) {
  const record::Recording recording = record::Recording::decode(bytes, "the recording");
  const auto samples = recording.stream("samples");
  const record::RecordingHeader& header = recording.header();
  std::vector<std::array<double, 2>> places;
  if (samples.size() < 3) return places;
  std::vector<Seen> sensors;
  for (const auto& info : header.streams) {
    if (info.name != "samples") continue;
    for (std::size_t i = 0; i < info.columns.size(); ++i)
      for (const auto& sensor : header.robot_info.sensors) {
        if (sensor.name != info.columns[i].name || samples[i].empty()) continue;
        std::vector<double> values = samples[i];
        if (header.floor && header.floor->light_line)
          for (double& value : values) value = 1.0 - value;
        const double least = *std::min_element(values.begin(), values.end());
        const double spread = *std::max_element(values.begin(), values.end()) - least;
        const double steady = least > kAlways ? kAlways : std::numeric_limits<double>::infinity();
        sensors.push_back({std::move(values), spread > kSpread ? least + kBegins * spread : steady});
      }
  }
  bool left = false;
  std::optional<std::size_t> last;
  for (std::size_t i = 0; i < samples[0].size(); ++i) {
    if (std::any_of(sensors.begin(), sensors.end(), [&](const Seen& s) { return s.values[i] > s.from; })) {
      left = false;
      last = i;
    } else if (!left && last && (samples[0][i] - samples[0][*last]) * 1e-6 > kLeft_s) {
      left = true;
      places.push_back({samples[1][*last], samples[2][*last]});
    }
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
