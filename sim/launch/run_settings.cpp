#include "sim/launch/run_settings.h"

#include <fmt/format.h>

#include "sim/base/option_values.h"

namespace robosim::launch {

void take(const RunTexts& texts, RunSettings& settings) {
  if (!texts.duration.empty()) settings.request.for_ns = simulated_time("--for", texts.duration);
  if (!texts.clock.empty()) settings.request.clock_ns = simulated_time("--clock", texts.clock);
  if (!texts.seed.empty()) settings.request.seed = seed_number(texts.seed);
  check_profile(settings.request.profile);
}

std::string scenario_text(const RunSettings& settings) {
  std::string text;
  if (!settings.script.empty()) text = script_text(settings.script);
  if (!text.empty() && text.back() != '\n') text += '\n';
  for (const std::string& send : settings.send) text += fmt::format("at 1s send \"{}\"\n", send);
  return text;
}

Launch launch_of(const RunSettings& settings) {
  Launch launch = settings;
  launch.request.script = scenario_text(settings);
  launch.request.script_file = settings.script.empty() ? "--send" : settings.script;
  return launch;
}

void fill_up(Fleet& fleet, const RunSettings& all) {
  const auto unless = [](std::string& own, const std::string& other) {
    if (own.empty()) own = other;
  };
  for (Member& member : fleet.members) {
    Launch& launch = member.launch;
    unless(launch.sketch, all.sketch);
    unless(launch.robot, all.robot);
    unless(launch.target, all.target);
    unless(launch.environment, all.environment);
    unless(launch.request.start, all.request.start);
    unless(launch.request.goal, all.request.goal);
    if (launch.request.script.empty() && (!all.script.empty() || !all.send.empty())) {
      launch.request.script = scenario_text(all);
      launch.request.script_file = all.script.empty() ? "--send" : all.script;
    }
    launch.libraries.insert(launch.libraries.begin(), all.libraries.begin(), all.libraries.end());
    launch.sanitize |= all.sanitize;
    launch.untrusted |= all.untrusted;
  }
}

}  // namespace robosim::launch
